// What scrolls can be reached and moved by keys, too; what fits into its place is no stop of the tab key.
function reachable() {
  for (const box of document.querySelectorAll(".table-wrapper, .highlight pre, div.math, .content .sig")) {
    if (box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight) {
      box.tabIndex = 0;
    } else {
      box.removeAttribute("tabindex");
    }
  }
}
addEventListener("load", reachable);
addEventListener("resize", reachable);
// A picture that the page shows smaller than it is opens in full when it is clicked.
function zoomable() {
  for (const picture of document.querySelectorAll(".content img")) {
    if (!picture.closest("a, .sphx-glr-thumbcontainer") && picture.naturalWidth > 1.1 * picture.clientWidth) {
      const link = document.createElement("a");
      link.href = picture.src;
      link.className = "full-size";
      picture.replaceWith(link);
      link.append(picture);
    }
  }
}
addEventListener("load", zoomable);
// The page of results has a field of its own: on a narrow screen that of the sidebar is out of sight.
function searchField() {
  const results = document.getElementById("search-results");
  if (!results) return;
  const form = document.createElement("form");
  form.className = "search-field";
  form.setAttribute("role", "search");
  form.innerHTML = '<input type="search" name="q" aria-label="Search in all pages" placeholder="Search"><button>Search</button>';
  form.elements.q.value = new URLSearchParams(location.search).get("q") || "";
  results.before(form);
}
addEventListener("DOMContentLoaded", searchField);
