// A formula or a table that is wider than its place scrolls there: the keyboard reaches it. Of a formula
// (formulas.css), a shade shows on which sides there is more, and its fault is in view at first.
"use strict";
(() => {
  const FAULT = ".boxed, .changed";
  const placed = new WeakSet(); // from then on, where it stands is the reader's choice

  const set = (box, attributes) => {
    for (const [name, value] of Object.entries(attributes))
      if (value) box.setAttribute(name, value);
      else box.removeAttribute(name);
  };

  // On which sides of a box a part of it is out of view.
  const out = (box, part) => {
    const [frame, inner] = [box, part].map((e) => e.getBoundingClientRect());
    return [inner.left < frame.left - 1 && "left", inner.right > frame.right + 1 && "right"].filter(Boolean);
  };

  const showFault = (box) => {
    const fault = box.querySelector(FAULT);
    if (!fault || placed.has(box)) return;
    placed.add(box);
    if (!out(box, fault).length) return;
    const [frame, inner] = [box, fault].map((e) => e.getBoundingClientRect());
    box.scrollLeft += inner.left - frame.left - Math.max(frame.width - inner.width, 0) / 2;
  };

  const mark = (box) => {
    const most = box.scrollWidth - box.clientWidth;
    const scrolls = most > 0 && box.clientWidth > 0;
    if (scrolls) showFault(box);
    const more = [box.scrollLeft > 1 && "left", box.scrollLeft < most - 1 && "right"].filter(Boolean);
    const faults = scrolls ? [...box.querySelectorAll(FAULT)] : [];
    set(box, {
      "data-more": scrolls && more.join(" "),
      "data-fault": [...new Set(faults.flatMap((fault) => out(box, fault)))].join(" "),
      tabindex: scrolls && "0",
      role: scrolls && "group",
      "aria-label": scrolls && `${box.matches(".wide") ? "table" : "formula"}, scrolls sideways`,
    });
  };

  // Set, unfolded, or on another screen: its size changes.
  const sizes = new ResizeObserver((changes) => changes.forEach((change) => mark(change.target)));
  addEventListener("DOMContentLoaded", () => {
    for (const box of document.querySelectorAll(".math, .wide")) sizes.observe(box);
  });
  document.addEventListener("scroll", (event) => event.target.matches?.(".math, .wide") && mark(event.target), true);
})();
