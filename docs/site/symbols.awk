# awk -f symbols.awk TAGS: the classes, functions and headers in a tag file of Doxygen, as symbols.js for search.js.
function content(line) {
  gsub(/^[^>]*>|<\/.*$/, "", line)
  gsub(/&lt;/, "<", line)
  gsub(/&gt;/, ">", line)
  gsub(/&quot;/, "\\\"", line)
  gsub(/&amp;/, "\\&", line)
  return line
}
function row(url, name, kind) {
  if (!((name, url) in seen)) printf "[\"%s\",\"%s\",\"%s\"],\n", url, name, kind
  seen[name, url] = 1
}
BEGIN { print "var siteSymbols = [" }
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
  file = content($0)
  sub(/(\.html)?$/, ".html", file)
  row(file, compound, compound_kind)
}
/<anchorfile>/ { anchor_file = content($0) }
/<anchor>/ && is_member && compound_kind != "file" { row(anchor_file "#" content($0), compound "::" name, kind) }
END { print "];" }
