# awk -v html=FOLDER -f finish.awk TAGS: what Doxygen leaves to do. TAGS is its tag file.
# Writes symbols.js, the classes, functions and headers for search.js. Then mends links of Doxygen 1.9.4: those of its tree
# from a header to a function, whose text is on the page of the namespace, those to lists of nested classes that are
# private and so not listed, and the menu's, as a list of pages has none that are below the landing page.

function content(line) {
  gsub(/^[^>]*>|<\/.*$/, "", line)
  gsub(/&lt;/, "<", line)
  gsub(/&gt;/, ">", line)
  gsub(/&quot;/, "\\\"", line)
  gsub(/&amp;/, "\\&", line)
  return line
}

function row(url, name, kind) {
  if (!((name, url) in seen)) printf "[\"%s\",\"%s\",\"%s\"],\n", url, name, kind > symbols
  seen[name, url] = 1
}

# Members that another page describes are linked to there.
function with_homes(line, done, url, anchor) {
  done = ""
  while (match(line, /"[A-Za-z0-9_]*_8hh\.html#[a-z0-9]*"/)) {
    url = anchor = substr(line, RSTART + 1, RLENGTH - 2)
    sub(/.*#/, "", anchor)
    if (anchor in home) url = home[anchor] "#" anchor
    done = done substr(line, 1, RSTART) url "\""
    line = substr(line, RSTART + RLENGTH)
  }
  return done line
}

function mend(file, line, lines, n, i, is_script, has_list, changed) {
  is_script = file ~ /\.js$/
  n = changed = has_list = 0
  while ((getline line < file) > 0) {
    lines[++n] = line
    if (line ~ / (id|name)="nested-classes"/) has_list = 1
  }
  close(file)
  for (i = 1; i <= n; i++) {
    line = lines[i]
    if (is_script) line = with_homes(line)
    if (file ~ /menudata\.js$/) sub(/\{text:"Related Pages",url:"pages.html"\}/, menu, line)
    if (!is_script && !has_list) sub(/<a href="#nested-classes">[^<]*<\/a>( &#124;)?/, "", line)
    changed = changed || line != lines[i]
    lines[i] = line
  }
  if (!changed) return
  printf "" > file
  for (i = 1; i <= n; i++) print lines[i] > file
  close(file)
}

BEGIN {
  symbols = html "/symbols.js"
  print "var siteSymbols = [" > symbols
  n = split("user Using whittle,dev For developers,changelog Changelog,contributing Contributing,reference The reference", pages, ",")
  for (i = 1; i <= n; i++) {
    at = index(pages[i], " ")
    menu = menu (i > 1 ? "," : "") "{text:\"" substr(pages[i], at + 1) "\",url:\"" substr(pages[i], 1, at - 1) ".html\"}"
  }
}
/<compound / || /<member / {
  is_member = /<member /
  match($0, /kind="[a-z]*"/)
  kind = substr($0, RSTART + 6, RLENGTH - 7)
  if (!is_member) compound_kind = kind
}
/<name>/ {
  name = content($0)
  if (!is_member) compound = name
}
/<filename>/ && !/\.md</ && compound_kind ~ /^(class|struct|namespace|file)$/ {
  page = content($0)
  sub(/(\.html)?$/, ".html", page)
  row(page, compound, compound_kind)
}
/<anchorfile>/ { anchor_page = content($0) }
/<anchor>/ && is_member && compound_kind != "file" {
  anchor = content($0)
  row(anchor_page "#" anchor, compound "::" name, kind)
  if (compound_kind == "namespace") home[anchor] = anchor_page
}
/<enumvalue / {
  match($0, / file="[^"]*/)
  page = substr($0, RSTART + 7, RLENGTH - 7)
  sub(/(\.html)?$/, ".html", page)
  match($0, / anchor="[^"]*/)
  home[substr($0, RSTART + 9, RLENGTH - 9)] = page
}
END {
  print "];" > symbols
  close(symbols)
  command = "find '" html "' -name '*.js' ! -name symbols.js ; grep -l '\"#nested-classes\"' '" html "'/*.html"
  while ((command | getline file) > 0) mend(file)
}
