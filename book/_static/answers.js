// What stands in a tab of an answer goes to the clipboard; what became of it is said on the button.
"use strict";
(() => {
  document.documentElement.classList.add("scripted");
  const SHOWN = 1500; // milliseconds

  const say = (button, text) => {
    const word = button.firstChild;
    word.textContent = text;
    setTimeout(() => (word.textContent = "Copy"), SHOWN);
  };

  document.addEventListener("click", async (event) => {
    const button = event.target.closest(".pastes .copy");
    if (!button) return;
    try {
      await navigator.clipboard.writeText(button.parentElement.querySelector("code").textContent);
      say(button, "Copied");
    } catch {
      say(button, "Not copied: the browser forbids it");
    }
  });
})();
