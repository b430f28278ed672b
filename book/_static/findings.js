// The long list of findings: sorted by its heads, filtered by paper, verdict, kind and consequence.
// Without this script the table is complete, in the order of consequence.
"use strict";
(() => {
  const list = document.querySelector("table.findings");
  if (!list || !window.DataTable) return;
  const heads = [...list.tHead.rows[0].cells].map((cell) => cell.textContent);
  const FILTERS = ["paper", "verdict", "kind", "changes"];
  const SORTS = ["changes", "paper", "verdict", "kind", "place"];

  // In the order in which they sort: by gravity or reach where the cells say so.
  const words = (column) => {
    const cells = [...list.tBodies[0].rows].map((row) => row.cells[column].dataset);
    const found = new Map(cells.map((data) => [data.search, data.order || ""]));
    return [...found.keys()].sort((a, b) => found.get(a).localeCompare(found.get(b)));
  };

  const labelled = (text, control, name) => {
    const label = document.createElement("label");
    label.className = name;
    control.setAttribute("aria-label", text); // without the words of its options
    label.append(text, control);
    return label;
  };

  const choice = (values, change) => {
    const select = document.createElement("select");
    for (const [value, text] of values) select.append(new Option(text, value));
    select.addEventListener("change", () => change(select.value));
    return select;
  };

  // As the table stands in the page: by reach, then by gravity, then by place.
  const first = ["changes", "verdict", "place"].map((head) => [heads.indexOf(head), "asc"]);
  const options = FILTERS.map((head) => [head, words(heads.indexOf(head))]);
  const table = new DataTable(list, {
    paging: false,
    autoWidth: false,
    order: first,
    layout: { topStart: null, topEnd: null, bottomStart: null, bottomEnd: null },
    columnDefs: [{ targets: heads.indexOf("finding"), orderable: false }],
  });

  const bar = document.createElement("form");
  bar.className = "filters";
  bar.setAttribute("role", "search");
  bar.setAttribute("aria-label", "filter the findings");
  for (const [head, found] of options) {
    const values = [["", "all"], ...found.map((word) => [word, word])];
    const filter = (value) =>
      table.column(heads.indexOf(head)).search(value, { exact: value !== "" }).draw();
    bar.append(labelled(head, choice(values, filter), "filter"));
  }
  const search = Object.assign(document.createElement("input"), { type: "search" });
  search.addEventListener("input", () => table.search(search.value).draw());
  bar.append(labelled("words", search, "filter"));
  const sorts = SORTS.map((head) => [heads.indexOf(head), head]);
  const place = [heads.indexOf("place"), "asc"];
  const sort = (value) => table.order([[Number(value), "asc"], place]).draw();
  bar.append(labelled("sort by", choice(sorts, sort), "sort"));
  const clear = Object.assign(document.createElement("button"), { type: "reset" });
  clear.textContent = "Show all";
  const status = document.createElement("span");
  status.setAttribute("role", "status");
  bar.append(clear, status);
  bar.addEventListener("submit", (event) => event.preventDefault());
  bar.addEventListener("reset", () => {
    table.search("").columns().search("");
    table.order(first).draw();
  });

  const count = () => {
    const { recordsDisplay, recordsTotal } = table.page.info();
    status.textContent = `${recordsDisplay} of ${recordsTotal} findings`;
  };
  table.on("draw", count);
  list.closest(".wide").before(bar);
  count();
})();
