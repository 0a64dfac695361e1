// The search box: sections of pages (sections.js) and names of the reference (symbols.js), from a server and from files.
// A result has all words that were typed. Names and titles come before text.
(function () {
  "use strict";
  var limit = 30;

  function load(file, then) {
    var script = document.createElement("script");
    script.src = file;
    script.onload = then;
    document.head.appendChild(script);
  }

  // How well a name fits: 3 equal, 2 begins or ends with it, 1 contains it, 0 not at all.
  function fit(name, query) {
    name = name.toLowerCase();
    if (name === query) return 3;
    return name.startsWith(query) || name.endsWith(" " + query) ? 2 : name.includes(query) ? 1 : 0;
  }

  function hasAll(text, words) {
    return words.every(function (word) { return text.includes(word); });
  }

  function excerpt(text, word) {
    var at = Math.max(0, text.toLowerCase().indexOf(word));
    var begin = at < 60 ? 0 : text.indexOf(" ", at - 60) + 1;
    return (begin ? "… " : "") + text.slice(begin, begin + 180) + (begin + 180 < text.length ? " …" : "");
  }

  function find(query) {
    var words = query.toLowerCase().split(/\s+/).filter(Boolean);
    if (!words.length) return [];
    var whole = words.join(" "), results = [];
    siteSections.forEach(function (row, i) {
      var title = row[1] === row[2] ? row[1] : row[1] + " › " + row[2], text = row[3].toLowerCase();
      var inTitle = hasAll(title.toLowerCase(), words);
      if (!inTitle && !hasAll(title.toLowerCase() + " " + text, words)) return;
      var rank = inTitle ? 4 + fit(row[2], whole) : 1 + Math.min(text.split(whole).length - 1, 9) / 5;
      if (/^(modules|tests)/.test(row[0])) rank -= 2;
      results.push({rank: rank - i / 1e5, url: row[0], title: title, more: excerpt(row[3], words[0])});
    });
    siteSymbols.forEach(function (row) {
      if (!hasAll(row[1].toLowerCase(), words)) return;
      var last = fit(row[1].split(/::|\//).pop(), whole);
      var isWhole = /class|struct|file|namespace/.test(row[2]);
      var rank = last ? 2 + 1.5 * last + (isWhole ? .5 : 0) : 1.5;
      results.push({rank: rank - row[1].length / 1e4, url: row[0], title: row[1], more: row[2]});
    });
    results.sort(function (a, b) { return b.rank - a.rank; });
    return results;
  }

  function element(tag, text, parent) {
    var made = document.createElement(tag);
    made.textContent = text;
    parent.appendChild(made);
    return made;
  }

  function show(list, query) {
    var results = find(query);
    list.textContent = "";
    list.hidden = !query.trim();
    results.slice(0, limit).forEach(function (result) {
      var link = element("a", "", list);
      link.href = result.url;
      element("b", result.title, link);
      element("small", result.more, link);
    });
    if (!results.length) element("div", "Nothing found", list);
    if (results.length > limit) element("div", results.length - limit + " more: type another word", list);
  }

  // Arrows go through the results, Enter follows one, Escape closes.
  function onKey(event, input, list) {
    var links = Array.from(list.querySelectorAll("a"));
    var at = links.indexOf(document.activeElement);
    if (event.key === "Escape") {
      list.hidden = true;
      input.blur();
    } else if (event.key === "ArrowDown" && at + 1 < links.length) {
      links[at + 1].focus();
    } else if (event.key === "ArrowUp" && at >= 0) {
      (links[at - 1] || input).focus();
    } else if (event.key === "Enter" && at < 0 && links.length) {
      links[0].click();
    } else {
      return;
    }
    event.preventDefault();
  }

  var row = document.getElementById("projectrow");
  var box = element("td", "", row);
  box.id = "site-search";
  var input = element("input", "", box);
  input.type = "search";
  input.placeholder = "Search pages and reference";
  input.setAttribute("aria-label", input.placeholder);
  var list = element("div", "", box);
  list.id = "site-results";
  list.hidden = true;

  var missing = ["sections.js", "symbols.js"], begun = false;
  input.addEventListener("focus", function () {
    if (begun) return;
    begun = true;
    missing.slice().forEach(function (file) {
      load(file, function () {
        missing.pop();
        if (!missing.length) show(list, input.value);
      });
    });
  });
  input.addEventListener("input", function () { if (!missing.length) show(list, input.value); });
  box.addEventListener("keydown", function (event) { if (event.key !== "Enter" || event.target === input) onKey(event, input, list); });
  document.addEventListener("click", function (event) {
    if (!box.contains(event.target) || event.target.closest("a")) list.hidden = true;
  });
})();
