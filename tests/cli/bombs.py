#!/usr/bin/env python3
"""usage: bombs_test.py MERKER [NAME...]

Small files that once took for ever, or all the memory there was, or that a careless reader would take so long for. Each is
made in two sizes; `merker check` or `merker test` must end by itself with an exit code of its own, within a few seconds
of processor time and 1 GB. The limits that stop them stand in docs/safety.md.
"""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

SECONDS = 10  # of processor time, also with sanitizers; each takes less than one
MEMORY = 2 << 30
BOMBS = {}


def bomb(make):
    BOMBS[make.__name__] = make
    return make


def block(code, declarations="", number=1, kind="FUNCTION FC {} : VOID"):
    name = kind.format(number)
    return f"{name}\n{declarations}\nBEGIN\nNETWORK\n{code}\nEND_{name.split()[0]}\n"


def function_block(number, declarations):
    return block("", f"VAR\n{declarations}END_VAR", number, "FUNCTION_BLOCK FB {}")


def data_type(number, members):
    return f"TYPE UDT {number}\nSTRUCT\n{members}\nEND_STRUCT;\nEND_TYPE\n"


def data_block(members, begin="", number=1):
    return f"DATA_BLOCK DB {number}\nSTRUCT\n{members}\nEND_STRUCT;\nBEGIN\n{begin}\nEND_DATA_BLOCK\n"


def of_type(number, name):
    return f"DATA_BLOCK DB {number}\n{name}\nBEGIN\nEND_DATA_BLOCK\n"


def lines(pattern, count):
    return "".join(pattern.format(i) for i in range(count))


def scenario(text):
    return {"a.awl": block("", number=1, kind="ORGANIZATION_BLOCK OB {}"), "a.scn": 'scenario "a"\n' + text}


def project(text, **files):
    return {"merker.toml": text, "a.awl": block("", number=1, kind="ORGANIZATION_BLOCK OB {}"), **files}


# --- types ---


@bomb
def unknown_types_of_unknown_types(n):
    return data_type(1, "x : XYZ;") + "".join(
        data_type(i, "".join(f"m{j} : UDT {i - 1};\n" for j in range(9))) for i in range(2, 27)) + data_block("a : UDT 26;")


@bomb
def instances_of_smaller_numbers(n):
    return function_block(1, "a : INT;\n") + "".join(
        function_block(i, "".join(f"m{j} : FB {i - 1};\n" for j in range(3))) for i in range(2, n // 5)) + of_type(1, f"FB {n // 5 - 1}")


@bomb
def instances_of_larger_numbers(n):
    return "".join(function_block(i, "".join(f"m{j} : FB {i + 1};\n" for j in range(3)))
                   for i in range(1, n // 5)) + of_type(1, "FB 1")


@bomb
def arrays_of_arrays_of_unknown_types(n):
    array = "ARRAY [0..32000] OF "
    return data_block(f"a : {array}STRUCT b : {array}STRUCT c : {array}XYZ; END_STRUCT; END_STRUCT;")


@bomb
def arrays_in_types(n):
    return data_type(1, "a : ARRAY [0..32000] OF XYZ;") + "".join(
        data_type(i, f"a : ARRAY [0..32000] OF UDT {i - 1};") for i in range(2, 6)) + data_block("a : UDT 5;")


@bomb
def six_dimensions(n):
    return data_block("a : ARRAY [" + ",".join(["-32768..32767"] * 6) + "] OF INT := 5 (1);")


@bomb
def dimensions(n):
    return data_block("a : ARRAY [" + ",".join(["1..2"] * n * 10) + "] OF INT;")


@bomb
def a_chain_of_types(n):
    return data_type(1, "x : INT;") + "".join(data_type(i, f"a : UDT {i - 1};") for i in range(2, n * 10))


@bomb
def types_that_double(n):
    return data_type(1, "x : BOOL;") + "".join(
        data_type(i, f"a : UDT {i - 1}; b : UDT {i - 1};") for i in range(2, 40)) + "".join(
            of_type(i, "UDT 39") for i in range(1, n))


@bomb
def a_circle_of_types(n):
    return "".join(data_type(i, f"a : UDT {i % n + 1};") for i in range(1, n + 1))


@bomb
def names_of_structures(n):
    return data_block("a,b,c,d,e,f,g,h : STRUCT " * 28 + " x : INT; " + "END_STRUCT; " * 28)


@bomb
def names_and_members(n):
    return data_block(",".join(f"a{i}" for i in range(n)) + " : STRUCT " + lines("x{} : BOOL;", n) + " END_STRUCT;")


@bomb
def names_with_a_comment(n):
    return data_block(",".join(f"a{i}" for i in range(n * 4)) + " : BOOL; //" + "c" * n * 20)


@bomb
def names_with_a_start_value(n):
    return data_block(",".join(f"a{i}" for i in range(n)) + " : ARRAY [0..32000] OF BYTE := 32001 (1);")


@bomb
def blocks_of_a_large_type(n):
    return data_type(1, lines("x{} : BOOL;", n)) + "".join(of_type(i, "UDT 1") for i in range(1, n))


@bomb
def blocks_of_megabytes(n):
    return data_type(1, "x : ARRAY [0..30000] OF WORD;") + data_type(2, lines("x{} : UDT 1;", 10)) + "".join(
        of_type(i, "UDT 2") for i in range(1, n))


def tree(first, leaf="BOOL", parts="m{}"):
    """Data types from `first` on, the last, first + 4, of 371,293 components."""
    return "".join(data_type(first + level, "".join(f"{parts.format(i)} : {f'UDT {first + level - 1}' if level else leaf};\n"
                                                    for i in range(13))) for level in range(5))


@bomb
def blocks_of_components(n):
    return data_type(1, "x : BOOL;") + "".join(data_type(i, f"a : UDT {i - 1};") for i in range(2, 28)) + "".join(
        f"DATA_BLOCK DB {i}\nSTRUCT\na : ARRAY [1..32000] OF UDT 27;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n" for i in range(1, n))


@bomb
def calls_that_compare_types(n):
    return (tree(1) + tree(11, parts="n{}") + data_block("v : UDT 5;") +
            block("", "VAR_IN_OUT\np : UDT 15;\nEND_VAR") + block("CALL FC 1 (p := DB1.v);\n" * n * 3, number=2))


@bomb
def calls_that_compare_many_types(n):
    count = int(n ** 0.5)
    return tree(1) + tree(11, parts="n{}") + "".join(
        block("", "VAR_IN_OUT\np : STRUCT a : UDT 15; END_STRUCT;\nEND_VAR", i) for i in range(count)) + block(
            "".join(f"CALL FC {i} (p := #v{j});\n" for i in range(count) for j in range(count)),
            "VAR_IN_OUT\n" + "".join(f"v{j} : STRUCT a : UDT 5; END_STRUCT;\n" for j in range(count)) + "END_VAR",
            kind="FUNCTION_BLOCK FB {}")


@bomb
def structures_in_structures(n):
    return data_block("a : STRUCT " * n * 10)


@bomb
def attributes(n):
    return data_block("a {" + "x := 'y';" * n * 10 + "} : INT;") + data_block("b { : INT;\n" * n, number=2)


# --- start values ---


@bomb
def repetitions(n):
    return data_block("a : ARRAY [0..32000] OF BYTE := " + "60000(" * 5 + "1" + ")" * 5 + ";")


@bomb
def deep_repetitions(n):
    return data_block("a : ARRAY [0..32000] OF BYTE := " + "1(" * n * 30 + "1" + ")" * n * 30 + ";")


@bomb
def repeated_blanks(n):
    return data_block("a : ARRAY [0..32000] OF BYTE := 32000(" + " " * n * 30 + "1);")


@bomb
def start_values_of_unknown_types(n):
    return data_block(lines("a{} : ARRAY [0..32000,0..15] OF XYZ := 65000 (1);\n", n))


@bomb
def assignments(n):
    return data_block(lines("v{0:06} : BOOL;\n", n), lines("v{0:06} := TRUE;\n", n))


# --- code ---


@bomb
def labels(n):
    return block(lines("L{0:03x}: U E 0.0;\nSPA L{0:03x};\n", n * 5))


@bomb
def labels_in_a_bracket(n):
    return block("U(;\n" + lines("{0:x}: U E 0.0;\n", n * 5) + ");\n" + lines("SPA A{0:x};\n", n * 5))


@bomb
def labels_in_a_line(n):
    return block(lines("a{}:", n * 50) + ": U E 0.0;")


@bomb
def labels_that_are_missing(n):
    return block("SPA M001;\n" * n * 20)


@bomb
def distributors(n):
    return block("SPL L1;\n" * n + "SPA L2;\n" * n * 2 + "L1: NOP 0;\nL2: NOP 0;")


@bomb
def brackets(n):
    return block("U(;" * n * 20) + block("(" * n * 100 + ";", number=2)


@bomb
def networks(n):
    return block("NETWORK\nTITLE = x\n" * n * 10)


@bomb
def titles(n):
    return block("TITLE =\n" * n * 20)


@bomb
def equals_signs(n):
    return block("= " * n * 100)


@bomb
def errors(n):
    return block("XYZ;\n" * n * 50)


@bomb
def errors_in_a_line(n):
    return block("\u00e4\u00f6\u00fc;" * n * 50)


@bomb
def long_names(n):
    return block('L "' + "x" * n * 300 + '";\nL #' + "y" * n * 300 + ";\n" + "Z" * n * 300 + ";")


@bomb
def long_numbers(n):
    return block("L " + "9" * n * 300 + ";\nL 2#" + "1" * n * 300 + ";\nL " + "0" * n * 300 + ".1;\nL DW#16#" +
                 "0" * n * 300 + ";\nL S5T#" + "1H" * n * 100 + ";")


@bomb
def long_operands(n):
    return block("L MW [" * n * 50 + ";\nL P#" + "1" * n * 50 + ".0;\nL #a" + "[1]" * n * 50 + ";\nL #a" +
                 ".b" * n * 50 + ";")


@bomb
def blanks(n):
    return block(" " * n * 300 + ";" + "\n" * n * 300 + "(* *)" * n * 100)


@bomb
def open_comments(n):
    return block("(*" * n * 300)


@bomb
def quotation_marks(n):
    return block("'" * n * 300 + "\n" + '"' * n * 300)


@bomb
def missing_parameters(n):
    return block("", "VAR_INPUT\n" + lines("v{0:06} : BOOL;\n", n // 3) + "END_VAR") + block("CALL FC 1;\n" * n,
                                                                                            number=2)


@bomb
def calls_of_calls(n):
    return "".join(block(f"CALL FC {i + 1};", number=i) for i in range(1, n))


@bomb
def one_block_many_times(n):
    return block("") * n * 3


@bomb
def blocks_without_end(n):
    return "TYPE UDT 1\n" * n * 10


@bomb
def checks(n):
    return block("U E 0.0; //= " + ", ".join(["VKE = 1"] * n * 10) + "\n" + "U E 0.0; //= VKE = 1\n" * n)


@bomb
def brackets_in_checks(n):
    return block("U E 0.0; //= " + "(" * n * 100 + "\n")


# --- STEP 5 ---


@bomb
def s5_labels(n):
    return {"a.s5": "PB 1\n" + lines("L{0:05}: U E 0.0\n", n * 20) + lines("SPA =L{0:05}\n", n * 20) + "BE\n"}


@bomb
def s5_blocks(n):
    return {"a.s5": "PB 1\n" * n * 20}


@bomb
def s5_parameters(n):
    return {"a.s5": "FB 200\nNAME:A\n" + lines("BEZ:A{} E BI\n", n * 10) + "BE\nPB 1\n" +
                    "SPA FB 200\nNAME:A\n" * n + "BE\n"}


@bomb
def s5_errors(n):
    return {"a.s5": "PB 1\n" + "XYZ\n" * n * 50 + "BE\n"}


@bomb
def s5_lists(n):
    return {"a.s5": "PB 1\nSPA FB 99\n" + "A : E 0.0\n" * n * 10 + "SPA FB 99\n! x\n" * n + "! x\n" * n * 10 + "BE\n"}


@bomb
def s5_lines(n):
    return {"a.s5": "PB 1\n" + "U E 0.0 " * n * 50 + "\n" + ":" * n * 100 + "\n" + "A" * n * 100 + "\nL KG " +
                    "9" * n * 100 + "\n" + "U " * n * 50 + "\nBE\n"}


@bomb
def s5_texts(n):
    return {"a.s5": "DB 10\nKS = " + "x" * n * 200 + "\nKS =" + "\u00e4" * n * 200 + "\n" + "KH 0000\n" * n * 20}


@bomb
def s5_networks(n):
    return {"a.s5": "PB 1\n" + "NETZWERK 1\n***\n" * n * 20 + "BE\n"}


# --- scenarios, symbols, projects ---


@bomb
def repeats_in_repeats(n):
    return scenario("repeat 2\n" * n * 30 + "end\n" * n * 30)


@bomb
def steps(n):
    return scenario("expect E 0.0 = 0\n" * n * 3 + "expect MW 300 = 0\n" * n)


@bomb
def long_steps(n):
    return scenario("expect E 0.0" + " " * n * 100 + "= 0\nset " + ", ".join(["E 0.0 = 0"] * n) + "\nset " + "(" * n * 50 +
                    "\nwait " + "9" * n * 100 + "s\nexpect " + "# " * n * 50)


@bomb
def symbols(n):
    return {"a.awl": block(""), "a.sdf": lines('"s{0}","M {0}.0","BOOL",""\n', n * 5) + '"x","M 0.0","BOOL","' +
                                         '" ' * n * 50 + " " * n * 100 + "\n"}


@bomb
def symbol_lines(n):
    return {"a.awl": block(""), "a.sym": '"' + " " * n * 100 + '" E 0.0 // x\n' + "x " * n * 50 + "\n"}


@bomb
def symbol_tuples(n):
    return {"a.awl": block(""), "a.dif": "TABLE\nDATA\n0,0\n\"\"\n" + '1,0\n"x"\n' * n * 20}


@bomb
def stars(n):
    return project('[program]\nsources = ["' + "*a" * 100 + '*b.awl"]\n', **{"a" * 60 + ".awl": ""})


@bomb
def folders(n):
    return project('[program]\nsources = ["' + "**/" * 40 + 'b.awl"]\n', **{"x/" * 25 + "a.awl": ""})


@bomb
def patterns(n):
    return project("[program]\nsources = [" + '"*.awl",' * n * 10 + "]\n")


@bomb
def patterns_of_stars(n):
    return project("[program]\nsources = [" + ('"' + "*a?" * 80 + 'b",\n') * 99 + "]\n",
                   **{"a" * 200 + f"{i}.awl": "" for i in range(n)})


@bomb
def patterns_that_almost_match(n):
    return project("[program]\nsources = [" + ('"*' + "a" * 120 + 'b",\n') * 99 + "]\n",
                   **{"a" * 240 + f"{i}.awl": "" for i in range(n)})


@bomb
def modules(n):
    return project("[[module]]\n" * n * 3)


@bomb
def good_modules(n):
    return project(lines('[[module]]\nname = "m{0}"\ntype = "SM 321 DI16xDC24V"\nslot = {0}\n', n))


@bomb
def plants(n):
    return project(lines('[[plant]]\nname = "p{0}"\nkind = "heater"\nin = "p{0}.x"\n', n))


@bomb
def keys(n):
    return project("[cpu]\n" + lines("k{} = 1\n", n * 5))


@bomb
def dotted_keys(n):
    return project("[" + ".".join(["a"] * n * 20) + "]\n")


@bomb
def tables_in_tables(n):
    return project("a = " + "{a=" * n * 10 + "\nb = " + "[" * n * 10)


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    if "ASAN_OPTIONS" not in os.environ:  # sanitizers reserve terabytes of addresses; they limit what is used themselves
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def run(merker, folder, files):
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    what = str(folder) if "merker.toml" in files else str(folder / next(iter(files)))
    command = ["test", what] if "a.scn" in files else ["check", what]
    if command[0] == "check" and "a.awl" in files and "merker.toml" not in files:
        command += ["--cpu", "generic"]
    return subprocess.run([merker, *command], capture_output=True, preexec_fn=limits, timeout=20 * SECONDS, check=False)


# The larger ones are about time and memory, which sanitizers change.
SIZES = (1000,) if os.environ.get("MERKER_BUILD") == "Debug" else (1000, 5000)


def attempt(merker, name, size):
    """Why it went wrong; nothing if it did not."""
    files = BOMBS[name](size)
    if isinstance(files, str):
        files = {"a.awl": files}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        try:
            result = run(merker, pathlib.Path(folder), files)
        except subprocess.TimeoutExpired:
            return "does not end"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if "-v" in sys.argv:
        print(f"{name} {size}: {sum(map(len, files.values()))} bytes, {after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime:.2f} s, exit {result.returncode}",
              result.stderr[:120])
    if result.returncode not in (0, 1, 4) or b"bad_alloc" in result.stderr:
        return f"exit {result.returncode}: {result.stderr[-200:]!r}"
    return ""


def main():
    merker, *names = [word for word in sys.argv[1:] if word != "-v"]
    failed = 0
    for name in names or BOMBS:
        for size in SIZES:
            if reason := attempt(merker, name, size):
                failed += 1
                print(f"FAILED {name} {size}: {reason}")
                break
    print(f"{len(names or BOMBS)} bombs, {failed} failed")
    return 1 if failed else 0


sys.exit(main())
