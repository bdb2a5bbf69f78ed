// What scrolls sideways can be reached and moved by keys, too; what fits into its place is no stop of the tab key.
function reachable() {
  for (const box of document.querySelectorAll(".table-wrapper, .highlight pre, div.math, .content .sig")) {
    if (box.scrollWidth > box.clientWidth) {
      box.tabIndex = 0;
    } else {
      box.removeAttribute("tabindex");
    }
  }
}
addEventListener("load", reachable);
addEventListener("resize", reachable);
