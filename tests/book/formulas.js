// Every formula of a page that cannot be seen whole, and why. Only geometry counts: where its ink is
// painted, what cuts, and how far what scrolls can be scrolled.
() => {
  const FORMULA = ".math, math, [role=math]"; // whatever sets it
  const SLACK = 1; // pixels: edges are rounded
  const AXES = [
    { start: "left", end: "right", overflow: "overflowX", scroll: "scrollLeft", length: "scrollWidth", border: "clientLeft", inner: "clientWidth" },
    { start: "top", end: "bottom", overflow: "overflowY", scroll: "scrollTop", length: "scrollHeight", border: "clientTop", inner: "clientHeight" },
  ];
  const plain = ({ left, right, top, bottom }) => ({ left, right, top, bottom });
  const within = (a, b) => ({
    left: Math.max(a.left, b.left), right: Math.min(a.right, b.right),
    top: Math.max(a.top, b.top), bottom: Math.min(a.bottom, b.bottom),
  });
  const around = (a, b) => ({
    left: Math.min(a.left, b.left), right: Math.max(a.right, b.right),
    top: Math.min(a.top, b.top), bottom: Math.max(a.bottom, b.bottom),
  });

  // An <svg> inside of an <svg> cuts a long stroke out of a longer one: that is how it is drawn.
  const opening = (svg) => {
    const [x, y, width, height] = ["x", "y", "width", "height"].map((name) => svg[name].baseVal.value);
    const matrix = svg.parentElement.getScreenCTM();
    const corners = [[x, y], [x + width, y + height]].map((at) => new DOMPoint(...at).matrixTransform(matrix));
    const [xs, ys] = [corners.map((at) => at.x), corners.map((at) => at.y)];
    return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
  };

  const ink = (formula) => {
    const boxes = [];
    const range = document.createRange();
    const nodes = document.createTreeWalker(formula, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
    for (let node = nodes.nextNode(); node; node = nodes.nextNode()) {
      const element = node.parentElement;
      // MathML's elements are as large as their ink, and text is as high as its line.
      const [own, outer] = [node, element].map((e) => e instanceof MathMLElement);
      const bare = node.data ? outer || !node.data.trim() : node.firstChild && !own;
      if (bare) continue;
      range.selectNode(node);
      let box = plain((node.data ? range : node).getBoundingClientRect());
      for (let svg = element.closest("svg"); svg?.ownerSVGElement; svg = svg.ownerSVGElement)
        box = within(box, opening(svg));
      if (box.right - box.left + box.bottom - box.top > 0) boxes.push(box);
    }
    return boxes.length ? boxes.reduce(around) : null;
  };

  // What holds a formula, from the inside: the parts that can cut it, and all that it stands in.
  const holders = (formula) => {
    const chain = [];
    let element = [...formula.querySelectorAll("svg:not(svg svg)")].at(-1) || formula;
    for (; element && element !== document.body; element = element.parentElement) chain.push(element);
    return chain;
  };

  const cuts = (style, axis) =>
    style[axis.overflow] !== "visible" || /paint|content|strict/.test(style.contain) || style.contentVisibility === "auto";

  const name = (element) => `<${[element.localName, ...element.classList].join(".")}>`;

  // Follow the ink outwards; what can be scrolled into view goes on as the box that scrolls.
  const lost = (formula) => {
    let seen = ink(formula);
    if (!seen) return "nothing is painted";
    for (const element of holders(formula)) {
      const style = getComputedStyle(element);
      if (style.display === "inline" || style.display === "contents") continue;
      const frame = element.getBoundingClientRect();
      for (const axis of AXES) {
        if (!cuts(style, axis)) continue;
        const from = frame[axis.start] + element[axis.border];
        const to = element[axis.inner] ? from + element[axis.inner] : frame[axis.end];
        const [before, after] = [from - seen[axis.start], seen[axis.end] - to];
        const scrolls = ["auto", "scroll"].includes(style[axis.overflow]);
        const spare = scrolls ? element[axis.length] - element[axis.inner] - element[axis.scroll] : 0;
        const beyond = Math.max(before - (scrolls ? element[axis.scroll] : 0), after - spare);
        if (beyond > SLACK) return `${name(element)} cuts ${Math.round(beyond)} px off`;
        if (scrolls && Math.max(before, after) > SLACK && element.tabIndex < 0)
          return `${name(element)} scrolls, but not by keyboard`;
        seen = { ...seen, [axis.start]: Math.max(seen[axis.start], from), [axis.end]: Math.min(seen[axis.end], to) };
      }
    }
    const beyond = Math.max(-seen.left, seen.right - document.documentElement.clientWidth);
    return beyond > SLACK ? `the screen cuts ${Math.round(beyond)} px off` : "";
  };

  const formulas = [...document.querySelectorAll(FORMULA)].filter((e) => !e.parentElement.closest(FORMULA) && e.checkVisibility());
  const faults = formulas.map((formula) => [formula, lost(formula)]).filter(([, fault]) => fault);
  const place = (formula) => formula.closest("[id]")?.id || "page";
  return { count: formulas.length, faults: faults.map(([formula, fault]) => `${place(formula)}: ${fault}`) };
}
