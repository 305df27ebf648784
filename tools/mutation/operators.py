"""What is changed in a line of C++. Each operator yields (column, length, replacement) for a line whose comments and literals
are blanked out. The code is formatted by clang-format: an operator of two operands has a space on both sides, a template's
brackets, a pointer and a reference have not."""
import re

BINARY = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&", "+": "-", "-": "+",
          "*": "/", "/": "*", "%": "/", "&": "|", "|": "&", "^": "&", "<<": ">>", ">>": "<<",
          "+=": "-=", "-=": "+=", "|=": "&=", "&=": "|=", "^=": "|=", "<<=": ">>=", ">>=": "<<="}
BINARY_SIGN = re.compile(r"(?<= )(?:<<=|>>=|<=>|<=|>=|==|!=|&&|\|\||<<|>>|[-+|&^]=|[-+*/%&|^<>])(?= |$)")
WORDS = {"true": "false", "false": "true", "std::min": "std::max", "std::max": "std::min", "front": "back", "back": "front",
         "std::round": "std::trunc", "std::llround": "std::llrint", "lower_bound": "upper_bound", "upper_bound": "lower_bound",
         "std::floor": "std::ceil", "std::ceil": "std::floor"}
WORD = re.compile(r"(?<![\w:.])(?:true|false|std::(?:min|max|round|llround|floor|ceil))(?!\w)"
                  r"|(?<=\.)(?:front|back)(?=\(\))|(?<=::)(?:lower_bound|upper_bound)(?=\()")
NUMBER = re.compile(r"(?<![\w.'])(0[xX][0-9A-Fa-f']+|\d[\d']*(?:\.\d+)?(?:e-?\d+)?)(?=[uUlLfF]*(?:_\w+)?(?![\w.']))")
NOT = re.compile(r"(?<![\w=!<>])!(?=[\w(*])")
CONDITION = re.compile(r"(?:^|\s|\})if \(")
STATEMENT = re.compile(r"(?:\+\+|--|\*)?[A-Za-z_][\w:]*(?:<[\w:, ]+>)?(?:[.(\[]|->|\+\+|--|\s[-+*/%&|^]?=\s|\s(?:<<|>>)=\s)")
NO_STATEMENT = re.compile(r"(?:return|using|if|for|while|switch|case|default|do|else|goto|throw|delete|static_assert|assert|"
                          r"constexpr|consteval|const|static|auto|struct|class|enum|template|typename|operator|public|private)\b")
TRIVIAL = ("{}", "0", "0u", "false", "nullptr", "std::nullopt", "*this", "\"\"")


def binary(code):
    for match in BINARY_SIGN.finditer(code):
        if match.group() in BINARY:
            yield match.start(), len(match.group()), BINARY[match.group()]


def words(code):
    for match in WORD.finditer(code):
        yield match.start(), len(match.group()), WORDS[match.group()]


def in_template(code, column):
    return re.search(r"\w<[^<>()]*$", code[:column]) and re.match(r"[^<>()]*>", code[column:])


def numbers(code):
    """A number one too many and one too few; a hexadecimal one, mostly a mask, shifted by a bit."""
    for match in NUMBER.finditer(code):
        text = match.group(1)
        if in_template(code, match.start()):
            continue
        for other in (shifted(text) if text[:2] in ("0x", "0X") else beside(text)):
            yield match.start(), len(text), other


def shifted(text):
    value, digits = int(text.replace("'", ""), 16), len(text.replace("'", "")) - 2
    fits = value << 1 < 1 << 4 * digits
    return [f"0x{value << 1 if fits else value >> 1:0{digits}X}"] if value else ["0x1"]


def beside(text):
    plain = text.replace("'", "")
    if re.search(r"[.e]", plain):
        return [repr(float(plain) + 1)] if float(plain) < 1000 else [repr(float(plain) * 2)]
    if len(plain) > 1 and plain[0] == "0":
        return []
    value = int(plain)
    return [str(value + 1)] + ([str(value - 1)] if value > 0 else [])


def negations(code):
    for match in NOT.finditer(code):
        yield match.start(), 1, ""
    for match in CONDITION.finditer(code):
        begin, end = match.end(), closing(code, match.end())
        if end:
            begin = code.rfind("; ", begin, end) + 2 if "; " in code[begin:end] else begin
            yield begin, end - begin, None  # None: "!(" what stands there ")"


def closing(code, begin):
    """The place of the parenthesis that closes the one in front of `begin`, or 0."""
    depth = 1
    for place in range(begin, len(code)):
        depth += {"(": 1, ")": -1}.get(code[place], 0)
        if depth == 0:
            return place
    return 0


def balanced(code):
    return all(code.count(a) == code.count(b) for a, b in ("()", "[]", "{}"))


def dropped(code):
    """A statement of one line that only does something, or a guard in front of the others."""
    text = code.strip()
    if not text.endswith(";") or not balanced(text) or re.search(r"\b(?:reserve|shrink_to_fit)\(", text):
        return
    column = code.index(text[0])
    guard = re.match(r"if \(", text) and re.search(r"\) (?:return\b[^;]*|continue|break);$", text)
    if guard or text == "break;" or text == "continue;" or (STATEMENT.match(text) and not NO_STATEMENT.match(text)):
        yield column, len(text), ";"


def returns(code):
    match = re.match(r"(\s*return )([^;]+);$", code)
    if match and balanced(code) and match.group(2).strip() not in TRIVIAL and match.group(2)[0] not in "{[":
        yield match.start(2), len(match.group(2)), "{}"


OPERATORS = (binary, words, numbers, negations, dropped, returns)
# Lines that hold no rule: what is included, what the compiler itself checks, names, heads of templates.
LEFT_OUT = re.compile(r"\s*(?:#|static_assert|using |namespace |template ?<|friend |typedef |extern |assert\()|.*(?:\boperator<=>|from_chars\()")


def mutants_of(line, code, continues):
    """(column, new text of the line) of every mutant; `continues`: a statement began on a line above."""
    if LEFT_OUT.match(code):
        return
    for operator in OPERATORS:
        if continues and operator is dropped:
            continue
        for column, length, new in operator(code):
            old = line[column:column + length]
            yield column, line[:column] + (f"!({old})" if new is None else new) + line[column + length:]
