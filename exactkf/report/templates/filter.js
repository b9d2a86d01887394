(function () {
  "use strict";
  const form = document.querySelector(".filter");
  const search = document.getElementById("search");
  const shown = document.getElementById("shown");
  const none = document.querySelector(".none");
  const claims = Array.from(document.querySelectorAll(".claim"));
  const groups = Array.from(document.querySelectorAll(".part, .paper"));

  function apply() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const verdict = form.elements.verdict.value;
    let count = 0;
    for (const claim of claims) {
      const fits = (!verdict || claim.dataset.verdict === verdict) && words.every((w) => claim.dataset.words.includes(w));
      claim.hidden = !fits;
      count += fits;
    }
    for (const group of groups) {
      group.hidden = !group.querySelector(".claim:not([hidden])");
    }
    none.hidden = count > 0;
    shown.textContent = count === claims.length ? count + " claims" : count + " of " + claims.length + " claims";
  }

  // a link to a claim that the filter hides shows everything again
  function reveal() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.closest("[hidden]")) {
      form.reset();
      apply();
      target.scrollIntoView();
    }
  }

  form.hidden = false;
  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("input", apply);
  window.addEventListener("hashchange", reveal);
  apply();
})();
