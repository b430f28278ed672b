// Buttons on claims: copy the right form, dispute the verdict. Nothing is sent anywhere.
// They are made when a row opens, because most of the many rows of a page never do.
"use strict";
(() => {
  const make = (tag, text, attributes = {}) => {
    const element = Object.assign(document.createElement(tag), attributes);
    element.textContent = text;
    return element;
  };

  const copy = async (text, done) => {
    try {
      await navigator.clipboard.writeText(text);
      done("Copied");
    } catch {
      done("Not copied: the browser forbids it");
    }
  };

  const dispute = (card, facts) => {
    const address = facts.querySelector("a.address");
    const page = location.pathname.split("/").pop() || "index.html";
    const fact = (name) => {
      const term = [...facts.querySelectorAll("dt")].find((e) => e.textContent === name);
      return term ? term.nextElementSibling.textContent.trim() : "";
    };
    const lines = [
      `Dispute: ${page.replace(/\.html$/, "")} ${address.textContent}`,
      "",
      `Place: ${card.cells[0].textContent.trim()}`,
      `Address: ${page}${address.getAttribute("href")}`,
      `Verdict: ${card.querySelector(".badge-verdict").textContent.trim()}`,
      facts.dataset.latex && `Right, by the report: ${facts.dataset.latex}`,
      facts.dataset.sympy && `The same for SymPy: ${facts.dataset.sympy}`,
      fact("decided by") && `Decided by: ${fact("decided by")}`,
      fact("derivation") && `Derivation: ${fact("derivation")}`,
      "",
      "What the PDF prints there (page, line):",
      "",
      "What I hold to be true, and why:",
      "",
    ];
    return lines.filter((line) => typeof line === "string").join("\n");
  };

  const show = (text) => {
    const dialog = make("dialog", "", { className: "dispute" });
    dialog.setAttribute("aria-labelledby", "dispute-title");
    const area = make("textarea", "", { value: text, rows: 14 });
    area.setAttribute("aria-label", "text of the issue");
    const status = make("span", "");
    status.setAttribute("role", "status");
    const copying = make("button", "Copy", { type: "button" });
    copying.onclick = () => copy(area.value, (said) => (status.textContent = said));
    const closing = make("button", "Close", { type: "button" });
    closing.onclick = () => dialog.close();
    const foot = make("p", "");
    const { reports } = window.PROJECT;
    const where = () => {
      const [title] = area.value.split("\n");
      const names = reports.startsWith("mailto:") ? ["subject", "body"] : ["title", "body"];
      return `${reports}?${names[0]}=${encodeURIComponent(title)}&${names[1]}=${encodeURIComponent(area.value)}`;
    };
    if (reports) {
      const send = make("a", reports.startsWith("mailto:") ? "Write a mail" : "Open an issue", { href: where(), rel: "noreferrer" });
      area.addEventListener("input", () => (send.href = where()));
      foot.append(send);
    }
    foot.append(copying, closing, status);
    const cure = reports ? "send it" : "open an issue with it where you got the project";
    dialog.append(
      make("h2", "Dispute this verdict", { id: "dispute-title" }),
      make("p", `Complete this text, and ${cure}. Nothing is sent before you do.`),
      area,
      foot,
    );
    dialog.onclose = () => dialog.remove();
    document.body.append(dialog);
    dialog.showModal();
  };

  // The right form stands in attributes of `place`.
  const tools = (place, name, card) => {
    const tools = make("p", "", { className: "tools" });
    const status = make("span", "");
    status.setAttribute("role", "status");
    const add = (text, act) => {
      const button = make("button", text, { type: "button", onclick: act });
      button.setAttribute("aria-label", `${text}: ${name}`);
      tools.append(button);
    };
    for (const [kind, label] of [["latex", "LaTeX"], ["sympy", "SymPy"]]) {
      const text = place.dataset[kind];
      if (text) add(`Copy ${label}`, () => copy(text, (said) => (status.textContent = said)));
    }
    add("Dispute", () => show(dispute(card, place)));
    tools.append(status);
    return tools;
  };

  document.addEventListener("facts", ({ target }) => {
    const facts = target.querySelector("dl.facts");
    if (facts) facts.after(tools(facts, facts.querySelector("a.address").textContent, facts.closest(".claim")));
  });
})();
