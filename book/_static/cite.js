// Cite a claim, as text or BibTeX; and copy what a button holds. Nothing is sent anywhere.
"use strict";
(() => {
  document.documentElement.classList.add("copying");
  const SHOWN = 1500; // milliseconds
  const make = (tag, text, attributes = {}) => Object.assign(document.createElement(tag), { textContent: text, ...attributes });

  const copy = async (button, text) => {
    const word = (button.dataset.word ??= button.textContent);
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      button.textContent = "Not copied: the browser forbids it";
    }
    setTimeout(() => (button.textContent = word), SHOWN);
  };

  document.addEventListener("click", ({ target }) => {
    const button = target.closest("button.copies");
    if (button) copy(button, button.dataset.text);
  });

  // Where the report lies on disk, the address is that within it.
  const addressOf = (anchor) => {
    const page = location.pathname.split("/").pop() || "index.html";
    return (location.protocol === "file:" ? page : location.href.replace(/#.*$/, "")) + anchor;
  };

  const citations = ({ authors, title, version }, address, what) => ({
    text: `${authors}. ${title}. Version ${version}. ${what}, ${address}`,
    BibTeX: [
      `@misc{omniproof:${address.split("/").pop().replace(".html#", ":")},`,
      `  author = {{${authors}}},`,
      `  title = {{${title}}},`,
      `  note = {Version ${version}; ${what.replaceAll("#", "\\#").replaceAll("_", "\\_")}},`,
      `  howpublished = {\\url{${address}}},`,
      "}",
      "",
    ].join("\n"),
  });

  document.addEventListener("facts", ({ target }) => {
    const facts = target.querySelector("dl.facts");
    const row = facts?.closest(".claim");
    if (!row || !window.PROJECT) return;
    const anchor = facts.querySelector("a.address").getAttribute("href");
    const place = row.cells[0].textContent.trim();
    const verdict = row.querySelector(".badge-verdict").textContent.trim().replace(/^\S+\s+/, "");
    const address = addressOf(anchor);
    const cite = make("p", "Cite: ", { className: "tools cite" });
    cite.append(make("a", "permalink", { href: anchor, title: address }));
    for (const [kind, text] of Object.entries(citations(window.PROJECT, address, `${place}: ${verdict}`))) {
      const button = make("button", kind, { type: "button", className: "copies" });
      button.dataset.text = text;
      button.setAttribute("aria-label", `Copy a citation of ${place}: ${kind}`);
      cite.append(button);
    }
    target.append(cite);
  });
})();
