# awk -v source=FOLDER -v out=FOLDER -v headers=FILE -v landing=FILE -v cmark=PROGRAM -f pages.awk PAGE...
# Makes pages of Doxygen out of Markdown. cmark-gfm renders it as GitHub does, and Doxygen takes the HTML as it is: its own
# Markdown differs. PAGE is a path within the sources; the first is the landing page. Writes into the folder out:
#   pages/ID.md       a page for Doxygen
#   html/             what goes beside Doxygen's HTML: pictures, and files/ with sources that pages point to
#   html/sections.js  the text of all sections, for search.js
# headers has the paths of all headers of the reference, landing the HTML that the landing page begins with. A link to
# nothing ends the run with status 1.

function id_of(page) {
  if (page == first) return "index"
  sub(/^docs\//, "", page)
  sub(/\.md$/, "", page)
  sub(/\/README$/, "", page)
  gsub(/[^A-Za-z0-9]/, "_", page)
  return tolower(page)
}

# The page under which one is listed.
function parent_of(page) {
  if (page ~ /^docs\/user\/formats\//) return "docs/user/formats.md"
  if (page ~ /^docs\/(user|dev)\/README\.md$/) return first
  if (page ~ /^docs\/user\//) return "docs/user/README.md"
  if (page ~ /^docs\/dev\//) return "docs/dev/README.md"
  if (page ~ /^modules\/engine\/.+\/README\.md$/ && page != "modules/engine/README.md") return "modules/engine/README.md"
  if (page ~ /^modules\//) return "docs/dev/architecture.md"
  if (page ~ /^tests\/.+\//) return "tests/README.md"
  if (page ~ /\//) return "docs/dev/README.md"
  return first
}

# Doxygen's name of a header's page: with the folders where two headers have one name.
function header_page(path, name) {
  name = path
  sub(/.*\//, "", name)
  if (n_named[name] > 1) {
    name = path
    sub(/^modules\//, "", name)
  }
  gsub(/_/, "__", name)
  gsub(/\//, "_2", name)
  gsub(/\./, "_8", name)
  return name ".html"
}

# The path of a link on a page, from the top of the sources.
function normal(page, link, parts, n, i, kept, path) {
  sub(/[^\/]*$/, "", page)
  n = split(page link, parts, "/")
  kept = 0
  for (i = 1; i <= n; i++) {
    if (parts[i] == "..") kept--
    else if (parts[i] != "." && parts[i] != "") parts[++kept] = parts[i]
  }
  for (i = 1; i <= kept; i++) path = path (i > 1 ? "/" : "") parts[i]
  return path
}

function exists(path, status) { return system("test -e '" source "/" path "'") == 0 }

function unescaped(html) {
  gsub(/&lt;/, "<", html)
  gsub(/&gt;/, ">", html)
  gsub(/&quot;/, "\"", html)
  gsub(/&amp;/, "\\&", html)
  return html
}

# The text of HTML.
function plain(html) {
  gsub(/<[^>]*>/, "", html)
  return unescaped(html)
}

function escaped(text) {
  gsub(/&/, "\\&amp;", text)
  gsub(/</, "\\&lt;", text)
  gsub(/>/, "\\&gt;", text)
  return text
}

# A source that a page points to, as a page of its own.
function file_page(path, name, target, line) {
  name = path
  gsub(/[^A-Za-z0-9.]/, "_", name)
  name = "files/" name ".html"
  if (name in written) return name
  written[name] = 1
  target = out "/html/" name
  print "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>" \
    path "</title><link href=\"../site.css\" rel=\"stylesheet\"></head><body><p><a href=\"../index.html\">Whittle</a> " path \
    "</p><pre>" > target
  while ((getline line < (source "/" path)) > 0) print escaped(line) > target
  close(source "/" path)
  print "</pre></body></html>" > target
  close(target)
  return name
}

# Where a link of a page goes in the site; empty for a folder, which has no page.
function resolved(page, link, fragment, path) {
  if (link ~ /^[a-z]+:/) return link
  if (link ~ /^#/) return link
  fragment = ""
  if (match(link, /#.*/)) {
    fragment = substr(link, RSTART)
    link = substr(link, 1, RSTART - 1)
  }
  path = normal(page, link)
  if (path in is_page) {
    if (parent_of(path) == page) add_child(page, path)
    return id_of(path) ".html" fragment
  }
  if (path == "docs/bibliography.bib") return "bibliography.html"
  if (path in is_header) return header_page(path)
  if (!exists(path)) {
    print page ": a link to " link ", which doesn't exist" > "/dev/stderr"
    failed = 1
  }
  if (system("test -d '" source "/" path "'") == 0) return ""
  return file_page(path)
}

function picture(page, link, path, name) {
  path = normal(page, link)
  name = path
  sub(/.*\//, "", name)
  if (system("cp '" source "/" path "' '" out "/html/" name "'") != 0) failed = 1
  return name
}

function add_child(page, child) {
  if (child in listed) return
  listed[child] = 1
  children[page] = children[page] " \\subpage " id_of(child)
}

# The line with its links and pictures as in the site.
function with_links(page, line, done, link, to) {
  done = ""
  while (match(line, /<(a href|img src)="[^"]*"/)) {
    done = done substr(line, 1, RSTART - 1)
    link = substr(line, RSTART, RLENGTH)
    line = substr(line, RSTART + RLENGTH)
    to = link
    gsub(/^[^"]*"|"$/, "", to)
    if (link ~ /^<img/) done = done "<img src=\"" picture(page, to) "\""
    else done = done ((to = resolved(page, to)) == "" ? "<a" : "<a href=\"" to "\"")
  }
  return done line
}

# The fragment that GitHub gives a heading.
function slug(title, text) {
  text = tolower(plain(title))
  gsub(/\342\200./, "", text)
  gsub(/[^a-z0-9_ \200-\377-]/, "", text)
  gsub(/ /, "-", text)
  return text (n_slugs[text]++ ? "-" n_slugs[text] - 1 : "")
}

function quoted(text) {
  gsub(/\\/, "\\\\", text)
  gsub(/"/, "\\\"", text)
  gsub(/[ \t\n]+/, " ", text)
  return "\"" text "\""
}

function end_section() {
  if (text != "") printf "[%s,%s,%s,%s],\n", quoted(url), quoted(title), quoted(section), quoted(text) > sections
  text = ""
}

# The HTML of a page; sets title, and in_code while within a block of C++.
function body(page, line, html, level, name, command) {
  command = cmark " -e table -e autolink -e strikethrough '" source "/" page "'"
  html = title = section = text = contents = ""
  in_code = 0
  url = id_of(page) ".html"
  for (name in n_slugs) delete n_slugs[name]
  while ((command | getline line) > 0) {
    if (line ~ /^<h[1-6]>/) {
      end_section()
      level = substr(line, 3, 1)
      line = substr(line, 5, length(line) - 9)
      name = slug(line)
      section = plain(line)
      if (title == "") {
        title = section
        continue
      }
      url = id_of(page) ".html#" name
      if (level == 2) contents = contents (contents ? " · " : "") "<a href=\"#" name "\">" escaped(section) "</a>"
      html = html "<h" level " id=\"" name "\">" with_links(page, line) " <a class=\"self\" href=\"#" name "\">#</a></h" level ">\n"
      continue
    }
    text = text " " plain(line)
    if (line ~ /<pre><code class="language-cpp">/) {
      sub(/<pre><code class="language-cpp">/, "\\endhtmlonly\n\n```{.cpp}\n", line)
      in_code = 1
    }
    if (in_code) {
      if (line ~ /<\/code><\/pre>/) {
        sub(/<\/code><\/pre>.*/, "```\n\n\\htmlonly[block]", line)
        in_code = 0
      }
      html = html unescaped(line) "\n"
      continue
    }
    gsub(/<table>/, "<div class=\"scroll\"><table>", line)
    gsub(/<\/table>/, "</table></div>", line)
    line = with_links(page, line)
    gsub(/\\/, "\\&#92;", line)
    gsub(/@/, "\\&#64;", line)
    html = html line "\n"
  }
  if (close(command) != 0 || title == "") {
    print page ": no page came out of it" > "/dev/stderr"
    failed = 1
  }
  end_section()
  if (contents ~ /·.*·/ && page != first) html = "<p class=\"toc\">On this page: " contents "</p>\n" html
  return html
}

BEGIN {
  first = ARGV[1]
  while ((getline path < headers) > 0) {
    is_header[path] = 1
    sub(/.*\//, "", path)
    n_named[path]++
  }
  sections = out "/html/sections.js"
  print "var siteSections = [" > sections
  for (i = 1; i < ARGC; i++) is_page[ARGV[i]] = 1
  for (i = 1; i < ARGC; i++) {
    html_of[ARGV[i]] = body(ARGV[i])
    title_of[ARGV[i]] = title
  }
  print "];" > sections
  while ((getline line < landing) > 0) top = top line "\n"
  html_of[first] = top html_of[first]
  for (i = 2; i < ARGC; i++) add_child(parent_of(ARGV[i]), ARGV[i])
  for (i = 1; i < ARGC; i++) {
    page = ARGV[i]
    target = out "/pages/" id_of(page) ".md"
    print "# " title_of[page] (page == first ? "" : " {#" id_of(page) "}") "\n" > target
    print "\\htmlonly[block]\n" html_of[page] "<div hidden=\"hidden\">\n\\endhtmlonly" > target
    print children[page] "\n\\htmlonly[block]\n</div>\n\\endhtmlonly" > target
    close(target)
  }
  exit failed
}
