// Every row of a paper: the faults first, and the details of a row when a reader asks for them.
// They are in a script of their own, because a page from disk can load nothing else.
"use strict";
addEventListener("DOMContentLoaded", () => {
  const box = document.querySelector(".rows");
  if (!box) return;
  const rows = [...box.querySelectorAll("tr.claim")];
  const { paper } = box.dataset;
  let loading = null;

  const details = () =>
    (loading ??= new Promise((done) => {
      const script = document.createElement("script");
      script.src = `rows/${paper}.js`;
      script.onload = () => done(window.rowsOf[paper]);
      script.onerror = () => done({});
      document.head.append(script);
    }));

  const open = async (row, button) => {
    const opens = !row.classList.contains("open");
    row.classList.toggle("open", opens);
    button.setAttribute("aria-expanded", opens);
    if (!opens || row.querySelector(".details")) return;
    const place = document.createElement("div");
    place.className = "details";
    row.lastElementChild.append(place);
    place.innerHTML = (await details())[row.id || row.dataset.row] ?? '<p>Its details are in <a href="ledger.csv">ledger.csv</a>.</p>';
    place.dispatchEvent(new CustomEvent("facts", { bubbles: true }));
  };

  // The place of a row becomes a button; rows that are filtered out get none.
  const equip = (row) => {
    const place = row.cells[0];
    if (place.querySelector("button")) return;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "more";
    button.setAttribute("aria-expanded", "false");
    button.append(...place.childNodes);
    button.onclick = () => open(row, button);
    place.append(button);
  };

  const sound = (row) => ["verified", "uncheckable"].includes(row.dataset.verdict);
  const trivial = (row) => "trivial" in row.dataset;
  const kinds = [...new Set(rows.map((row) => row.dataset.claim))];
  const verdicts = [...new Set(rows.map((row) => row.dataset.verdict))];
  const choices = {
    show: {
      options: [
        ["faults", "faults"],
        ["remarks", "faults, and remarks on wording and references"],
        ["all", "every row"],
        ...verdicts.map((verdict) => [verdict, `verdict: ${verdict}`]),
      ],
      passes: (row, value) =>
        value === "all" ||
        value === row.dataset.verdict ||
        (value === "remarks" && !sound(row)) ||
        (value === "faults" && !sound(row) && !trivial(row)),
    },
    kind: {
      options: [["", "all"], ...kinds.map((kind) => [kind, kind])],
      passes: (row, value) => !value || value === row.dataset.claim,
    },
  };
  const { form, update } = filters("filter the rows", "rows", rows, choices, (shown) => {
    shown.forEach(equip);
    const bodies = new Set(shown.map((row) => row.parentElement));
    for (const body of box.querySelectorAll("tbody")) body.classList.toggle("out", !bodies.has(body));
  });
  box.prepend(form);
  update();

  // A link to a row, or to the rows of an equation, shows them whatever the filter says.
  const reveal = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    const body = target?.closest(".rows tbody");
    if (!body) return;
    const row = target.closest("tr.claim");
    const wanted = row && !target.matches("span") ? [row] : [...body.querySelectorAll("tr.claim")];
    if (wanted.some((each) => each.classList.contains("out"))) {
      body.classList.remove("out");
      for (const each of wanted) each.classList.remove("out");
      wanted.forEach(equip);
    }
    if (wanted.length === 1 && !row?.classList.contains("open")) wanted[0].querySelector("button.more").click();
    details().then(() => target.scrollIntoView());
  };
  addEventListener("hashchange", reveal);
  reveal();
});
