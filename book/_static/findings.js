// The long list of findings: sorted by its heads, filtered by paper, verdict, kind and consequence.
// Without this script the table is complete, in the order of consequence.
"use strict";
addEventListener("DOMContentLoaded", () => {
  const list = document.querySelector("table.findings");
  if (!list) return;
  const heads = [...list.tHead.rows[0].cells];
  const body = list.tBodies[0];
  const rows = [...body.rows];
  const column = (name) => heads.findIndex((cell) => cell.textContent === name);
  const order = (cell) => cell.dataset.order || cell.textContent;
  const compare = (one, other, k) => order(one.cells[k]).localeCompare(order(other.cells[k]));

  // In the order in which they sort: by gravity or reach where the cells say so.
  const choice = (name) => {
    const k = column(name);
    const sorted = rows.toSorted((one, other) => compare(one, other, k));
    const values = [...new Set(sorted.map((row) => row.cells[k].dataset.search))];
    return {
      options: [["", "all"], ...values.map((value) => [value, value])],
      passes: (row, value) => !value || row.cells[k].dataset.search === value,
    };
  };

  // Rows that sort alike keep the order in which they stand in the page.
  const sort = (k) => {
    const falls = heads[k].getAttribute("aria-sort") === "ascending";
    for (const cell of heads) cell.removeAttribute("aria-sort");
    heads[k].setAttribute("aria-sort", falls ? "descending" : "ascending");
    body.append(...rows.toSorted((one, other) => (falls ? -1 : 1) * compare(one, other, k)));
  };

  for (const [k, cell] of heads.entries()) {
    if (cell.textContent === "finding") continue;
    const button = document.createElement("button");
    button.type = "button";
    button.append(...cell.childNodes);
    button.onclick = () => sort(k);
    cell.append(button);
  }
  const names = ["paper", "verdict", "kind", "changes"];
  const show = {
    options: [["faults", "faults"], ["", "faults, and remarks on wording and references"]],
    passes: (row, value) => !value || !("trivial" in row.dataset),
  };
  const choices = { show, ...Object.fromEntries(names.map((name) => [name, choice(name)])) };
  const { form, update } = filters("filter the findings", "findings", rows, choices, () => {});
  list.closest(".wide").before(form);
  update();
});
