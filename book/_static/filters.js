// A form that filters a list: choices, words, how many are shown. Lists are complete without it.
"use strict";
window.filters = (() => {
  const make = (tag, attributes, ...children) => {
    const element = Object.assign(document.createElement(tag), attributes);
    element.append(...children);
    return element;
  };

  const labelled = (text, control) => {
    control.setAttribute("aria-label", text); // without the words of its options
    return make("label", { className: "filter" }, text, control);
  };

  // rows: elements; choices: { name: { options: [[value, words], …], passes: (row, value) => bool } }.
  // `shown` is called with the rows that pass, whenever they change.
  return (name, noun, rows, choices, shown) => {
    const selects = Object.entries(choices).map(([key, { options, passes }]) => {
      const select = make("select", { name: key }, ...options.map(([value, text]) => new Option(text, value)));
      return { key, select, passes };
    });
    const words = make("input", { type: "search", name: "words" });
    const reset = make("button", { type: "button" }, "Reset");
    const status = make("span", {});
    status.setAttribute("role", "status");
    const form = make(
      "form",
      { className: "filters" },
      ...selects.map(({ key, select }) => labelled(key, select)),
      labelled("words", words),
      reset,
      status,
    );
    form.setAttribute("role", "search");
    form.setAttribute("aria-label", name);

    const update = () => {
      const wanted = words.value.trim().toLowerCase();
      const passing = rows.filter(
        (row) =>
          selects.every(({ select, passes }) => passes(row, select.value)) &&
          (!wanted || row.textContent.toLowerCase().includes(wanted)),
      );
      const found = new Set(passing);
      for (const row of rows) row.classList.toggle("out", !found.has(row));
      status.textContent = `${passing.length} of ${rows.length} ${noun}`;
      shown(passing);
    };
    form.addEventListener("input", update);
    form.addEventListener("submit", (event) => event.preventDefault());
    reset.addEventListener("click", () => {
      form.reset();
      update();
    });
    return { form, update };
  };
})();
