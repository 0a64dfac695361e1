# find SITE -type f | awk -f links.awk: checks a site of HTML. Every relative link, picture and script of a page, and every
# page that a script names, is a file of the site, and every fragment an id there. No page has an id twice, but for
# Doxygen's "details".

function problem(text) {
  print text
  n_problems++
}

# to: as on the page; kept for the end, when all ids are known.
function keep(page, to) {
  if (to ~ /^[a-z]+:/ || to == "") return
  links[page "\t" to] = 1
  n_links++
}

function add_id(page, id) {
  if ((page "#" id) in ids && id != "details") problem(page ": two elements have the id " id)
  ids[page "#" id] = 1
}

# All values of ATTRIBUTE="..." in tags of the line.
function read_html(page, line, tag, name, value) {
  while (match(line, /<[a-zA-Z][^>]*>/)) {
    tag = substr(line, RSTART, RLENGTH)
    line = substr(line, RSTART + RLENGTH)
    while (match(tag, / (href|src|id|name)="[^"]*"/)) {
      name = value = substr(tag, RSTART + 1, RLENGTH - 2)
      tag = substr(tag, RSTART + RLENGTH)
      sub(/=.*/, "", name)
      sub(/^[^"]*"/, "", value)
      gsub(/&amp;/, "\\&", value)
      if (name == "id") add_id(page, value)
      else if (name == "name") ids[page "#" value] = 1
      else keep(page, value)
    }
  }
}

function read_script(page, line, value) {
  while (match(line, /"[^" ()<>]*\.html(#[^" ()<>]*)?"/)) {
    value = substr(line, RSTART + 1, RLENGTH - 2)
    line = substr(line, RSTART + RLENGTH)
    keep(page, value)
  }
}

function check(page, to, fragment, folder) {
  fragment = ""
  if (match(to, /#.*/)) {
    fragment = substr(to, RSTART + 1)
    to = substr(to, 1, RSTART - 1)
  }
  sub(/\?.*/, "", to)
  folder = page
  sub(/[^\/]*$/, "", folder)
  to = to == "" ? page : folder to
  while (sub(/[^\/]+\/\.\.\//, "", to)) {}
  if (!(to in files)) problem(page ": no file " to)
  else if (fragment != "" && !((to "#" fragment) in ids)) problem(page ": no id " fragment " in " to)
}

{ files[$0] = 1 }

END {
  for (file in files) {
    if (file !~ /\.html$/ && (file !~ /\.js$/ || file ~ /\/(jquery|menu|navtree|resize|dynsections|search)\.js$/)) continue
    while ((getline line < file) > 0) {
      if (file ~ /\.js$/) read_script(file, line)
      else read_html(file, line)
    }
    close(file)
  }
  for (link in links) {
    split(link, part, "\t")
    check(part[1], part[2])
  }
  if (n_links < 10000) problem("only " n_links + 0 " links: this isn't the site")
  print n_links " links"
  exit n_problems > 0
}
