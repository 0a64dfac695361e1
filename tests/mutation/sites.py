"""Finds the tokens of C++ sources that can be changed, and what they can be changed to."""

import collections
import glob
import os
import re

# What this project's sources ask of the compiler, as it is with GCC on x86-64 Linux.
DEFINED = {"__linux__", "__GNUC__", "__x86_64__", "__GLIBCXX__", "WHITTLE_HAS_LANES", "WHITTLE_CHOOSES_AVX2",
           "__has_builtin"}
NOT_COMPILED = ("modules/core/include/whittle/core/detail/lane_array.hh",)  # for compilers without vectors

# Operators with a space on each side, as the formatter puts them: so angle brackets of templates are none.
BINARY = {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["*"], "+=": ["-="], "-=": ["+="], "*=": ["/="],
          "/=": ["*="], "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="],
          "!=": ["=="], "&&": ["||"], "||": ["&&"], "|": ["&"], "&": ["|"], "|=": ["&="], "&=": ["|="], "^": ["|"]}
WORDS = {"true": ["false"], "false": ["true"], "std::min": ["std::max"], "std::max": ["std::min"],
         "cwiseMin": ["cwiseMax"], "cwiseMax": ["cwiseMin"], "std::floor": ["std::ceil"], "std::ceil": ["std::floor"],
         "continue": ["break"], "break": ["continue"]}

TOKENS = re.compile(
    r"(?<= )(?P<binary>[-+*/%|&^<>=!]{1,2})(?= )"
    r"|(?P<step>\+\+|--)"
    r"|(?<![\w.:])(?P<word>std::(?:min|max|floor|ceil)|true|false|continue|break)(?!\w)"
    r"|(?<=\.)(?P<member>cwiseMin|cwiseMax)(?!\w)"
    r"|(?<![\w.])(?P<number>(?:\d[\d']*\.\d*(?:e[-+]?\d+)?|\d[\d']*(?:e[-+]?\d+)?)[fuUlL]*)(?![\w.])"
    r"|(?P<sign>(?<=[(=,] )-(?=\w)|(?<=\()-(?=\w)|(?<=return )-(?=\w))"
    r"|(?P<negation>!(?=[\w(]))"
    r"|(?<!\w)(?P<condition>return (?=[^;{]*(?: (?:==|!=|<|<=|>|>=|&&|\|\|) |!)[^;]*;)[^;{]*|if \(|while \()")

COMMENTS_AND_STRINGS = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<![\w])'(?:\\.|[^'\\\n])+'",
                                  re.DOTALL)

SourceLine = collections.namedtuple("SourceLine", "path number changes")


class Change(collections.namedtuple("Change", "path line begin end before after")):
    """Characters [begin, end) of a file become `after`."""

    def apply(self, text):
        return text[:self.begin] + self.after + text[self.end:]

    def __str__(self):
        return f"{self.path}:{self.line}: `{self.before}` => `{self.after}`"


def blanked(text):
    """The text without comments and strings, at the same places."""
    return COMMENTS_AND_STRINGS.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def holds(directive):
    """Whether the lines after #if, #ifdef or #ifndef are compiled."""
    kind, condition = directive.groups()
    if kind == "ifdef":
        return condition.strip() in DEFINED
    if kind == "ifndef":
        return condition.strip() not in DEFINED
    condition = re.sub(r"defined\((\w+)\)", lambda match: str(match.group(1) in DEFINED), condition)
    condition = re.sub(r"__has_builtin\(\w+\)", "True", condition)
    return bool(eval(condition.replace("&&", " and ").replace("||", " or ").replace("!", " not ")))  # our own sources


def compiled_lines(text):
    """The numbers of lines, from 1 on, that the preprocessor passes on here."""
    taken, numbers, continued = [], set(), False
    for number, line in enumerate(text.split("\n"), 1):
        directive = re.match(r"\s*#\s*(if|ifdef|ifndef)\s+(.*)", line)
        is_directive = continued or line.lstrip().startswith("#")
        continued = is_directive and line.endswith("\\")
        if directive:
            taken.append(holds(directive))
        elif re.match(r"\s*#\s*else", line):
            taken[-1] = not taken[-1]
        elif re.match(r"\s*#\s*endif", line):
            taken.pop()
        elif not is_directive and all(taken):
            numbers.add(number)
    return numbers


def without_assertions(text):
    """assert and static_assert blanked: the optimised build has none of the one, and the other is no test."""
    return re.sub(r"\b(?:static_)?assert\(.*?\);", lambda match: re.sub(r"[^\n]", " ", match.group()), text,
                  flags=re.DOTALL)


def other_numbers(token):
    value = re.match(r"[\d'.]+(?:e[-+]?\d+)?", token).group()
    suffix = token[len(value):]
    value = value.replace("'", "")
    if "." in value or "e" in value:
        if float(value) == 0:
            return ["1.0" + suffix]
        return ["0.0" + suffix, repr(2 * float(value)) + suffix]
    if len(value) > 1 and value.startswith("0"):
        return []
    number = int(value)
    return [str(number + 1) + suffix] + ([str(number - 1) + suffix] if number > 0 else [])


def end_of_condition(text, begin):
    """The place of the bracket that closes the one before `begin`."""
    depth = 1
    for place in range(begin, len(text)):
        depth += {"(": 1, ")": -1}.get(text[place], 0)
        if depth == 0:
            return place
    raise ValueError("a bracket is not closed")


def changes_of(match, text, code):
    """(begin, end, after) for a token."""
    kind, token = match.lastgroup, match.group()
    begin, end = match.span()
    if kind == "binary":
        if code[:begin].endswith("template ") or code[:begin].endswith("operator "):
            return []
        return [(begin, end, other) for other in BINARY.get(token, [])]
    if kind in ("word", "member"):
        return [(begin, end, other) for other in WORDS[token]]
    if kind == "step":
        return [(begin, end, "--" if token == "++" else "++")]
    if kind == "number":
        return [(begin, end, other) for other in other_numbers(token)]
    if kind in ("sign", "negation"):
        return [(begin, end, "")]
    if token.startswith("return"):
        return [(begin, end, f"return !({text[begin + len('return '):end]})")]
    close = end_of_condition(code, end)
    condition = text[end:close]
    return [] if "constexpr" in token or ";" in condition or " = " in condition else [
        (begin, close, f"{token}!({condition})")]


def matches(code):
    """Tokens; those inside the condition of an if or return are tokens of their own, too."""
    place = 0
    while True:
        match = TOKENS.search(code, place)
        if not match:
            return
        yield match
        place = match.start() + 1 if match.lastgroup == "condition" else match.end()


def lines_of_file(tree, path):
    with open(os.path.join(tree, path), encoding="utf-8", newline="") as file:
        text = file.read()
    blank = blanked(text)
    compiled = compiled_lines(blank)
    code = without_assertions(blank)
    changes = collections.defaultdict(list)
    for match in matches(code):
        number = code.count("\n", 0, match.start()) + 1
        if number not in compiled:
            continue
        for begin, end, after in changes_of(match, text, code):
            changes[number].append(Change(path, number, begin, end, text[begin:end], after))
    return [SourceLine(path, number, changes[number]) for number in sorted(changes)]


def lines_with_sites(tree, modules):
    """All lines of the modules' sources and headers that something can be changed in."""
    lines = []
    for module in modules:
        paths = glob.glob(os.path.join(tree, "modules", module, "**", "*.??"), recursive=True)
        for path in sorted(os.path.relpath(path, tree).replace(os.sep, "/") for path in paths):
            if path.endswith((".hh", ".cc")) and path not in NOT_COMPILED:
                lines += lines_of_file(tree, path)
    return lines
