from harness import *


class Check(Case):
    def test_a_good_program(self):
        self.write("a.awl", PROGRAM)
        call = self.expect(GOOD, "check", "a.awl")
        self.assertEqual(call.err, "")
        self.assertEqual(call.out, "a.awl: 1 block, 0 errors, 0 warnings\n")

    def test_a_merker_toml_that_cannot_be_read_is_the_only_problem(self):
        self.write("p/merker.toml", '[[station]]\nname = "A"\nfolder = "a"\n[[station\n')
        err = self.expect(PROBLEMS, "check", "p").err
        self.assertRegex(err, r"^p/merker\.toml:4:10: error: ")
        self.assertNotIn("P0708", err)

    def test_problems_have_place_code_line_and_caret(self):
        self.write("a.awl", block("      U     M 300.0\n      =     A 0.0"))
        call = self.expect(PROBLEMS, "check", "a.awl")
        lines = call.err.splitlines()
        self.assertRegex(lines[0], r"^a\.awl:4:\d+: error: .*\[P\d{4}\]$")
        self.assertIn("U     M 300.0", lines[1])
        self.assertIn("^", lines[2])
        self.assertEqual(lines[1].index("M 300.0"), lines[2].index("^"))

    def test_all_problems_in_one_pass_and_in_all_files(self):
        self.write("a.awl", block("      U     M 300.0\n      FLY\n      L     MW 4711"))
        self.write("b.awl", block("      SPA   nowhere"))
        err = self.expect(PROBLEMS, "check", "a.awl", "b.awl").err
        for place in ("a.awl:4:", "a.awl:5:", "a.awl:6:", "b.awl:4:"):
            self.assertIn(place, err)

    def test_json_has_the_same_fields(self):
        self.write("a.awl", block("      U     M 300.0"))
        call = self.expect(PROBLEMS, "check", "--json", "a.awl")
        problem = call.json["problems"][0]
        self.assertEqual({"file", "line", "column", "length", "severity", "code", "message"}, set(problem))
        text = f"{problem['file']}:{problem['line']}:{problem['column']}: {problem['severity']}: {problem['message']} [{problem['code']}]"
        self.assertEqual(call.err.splitlines()[0], text)

    def test_json_without_problems(self):
        self.write("a.awl", PROGRAM)
        self.assertEqual(self.expect(GOOD, "check", "--json", "a.awl").json, {"problems": []})

    def test_the_model_decides_about_limits(self):
        self.write("a.awl", block("      U     M 300.0\n      =     M 300.1"))
        self.expect(PROBLEMS, "check", "a.awl")
        self.expect(GOOD, "check", "--cpu", "generic", "a.awl")
        self.assertIn("317", self.expect(USAGE, "check", "--cpu", "317", "a.awl").err)

    # S7-SRC-10: SE is the on-delay in German and the extended pulse in international mnemonics.
    def test_the_mnemonics_of_the_sources(self):
        mixed = block("      U     E 0.0\n      A     I 0.1\n      L     S5T#1S\n      SE    T 1\n      =     A 0.0")
        self.write("a.awl", mixed)
        call = self.expect(PROBLEMS, "check", "a.awl")
        self.assertIn("[P0355]", call.err)
        self.assertIn("[P0357]", call.err)
        for word, code in (("german", "SE    T 1"), ("english", "SV    T 1")):
            self.assertIn("1 warning\n", self.expect(GOOD, "check", "--source-mnemonics", word, "a.awl").out)
            self.assertIn(code, self.expect(GOOD, "list", "--code", "--source-mnemonics", word, "a.awl").out)
            self.write("p/merker.toml", f'[program]\nmnemonics = "{word}"\n')
            self.write("p/a.awl", mixed)
            self.assertIn(code, self.expect(GOOD, "list", "--code", "p").out)
        self.assertIn("SE    T 1", self.expect(GOOD, "list", "--code", "--source-mnemonics", "german", "p").out)
        self.write("p/merker.toml", '[program]\nmnemonics = "French"\n')
        self.assertIn("merker.toml:2:", self.expect(PROBLEMS, "check", "p").err)
        self.expect(USAGE, "check", "--source-mnemonics", "fr", "a.awl")

    # S7-OPEN-39: no error, since blocks without OB 1 may be a library
    def test_a_program_without_ob_1(self):
        self.write("a.awl", PROGRAM.replace("OB 1", "OB 100"))
        call = self.expect(GOOD, "check", "a.awl")
        self.assertIn("a.awl: warning: the program has no OB 1", call.err)
        self.assertIn("0 errors, 1 warning\n", call.out)

    def test_nothing_and_garbage(self):
        self.write("empty.awl", "")
        self.assertIn("empty.awl", self.expect(GOOD, "check", "empty.awl").err)
        self.write("bin.awl", bytes(range(256)) * 64)
        self.assertIn("an AWL source is a text", self.expect(PROBLEMS, "check", "bin.awl").err)
        self.write("old.s5", "U E 0.0\n")
        self.assertIn("P1101", self.expect(PROBLEMS, "check", "old.s5").err)

    def test_a_hundred_megabytes(self):
        self.write("big.awl", b"      FLY   1 2 3\n" * 100)  # the same words, once as a check of the small case
        self.expect(PROBLEMS, "check", "big.awl")
        self.write("big.awl", b"x" * 100_000_000)
        self.assertLess(len(self.expect(PROBLEMS, "check", "big.awl", timeout=120).err), 10_000_000)

    def test_every_encoding_of_a_comment_and_a_symbol(self):
        source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      U     \"Tür\"   // geöffnet, für Höhe\n      =     A 0.0\nEND_ORGANIZATION_BLOCK\n"
        symbols = "\"Tür\" E 0.0 BOOL // Öffner\n"
        for encoding in ("utf-8", "utf-8-sig", "cp1252", "cp850", "cp437"):
            with self.subTest(encoding):
                self.write("a.awl", source.encode(encoding))
                self.write("a.sym", symbols.encode(encoding))
                self.expect(GOOD, "check", "a.awl")


    def test_a_source_for_a_larger_cpu(self):
        self.write("a.awl", block("      U     M 300.0\n      =     A 0.0"))
        hint = "a.awl: 0 errors with --cpu generic-4"
        err = self.expect(PROBLEMS, "check", "a.awl").err
        self.assertIn("flag byte 300", err)
        self.assertIn(hint, err)
        self.assertNotIn(hint, self.expect(PROBLEMS, "check", "a.awl", "--cpu", "314C-2 PtP").err)
        self.expect(GOOD, "check", "a.awl", "--cpu", "generic-4")

    def test_symbol_files_beside_others(self):
        self.write("a.awl", block("      U     \"Start\"\n      =     \"Lamp\""))
        self.write("lists/one.sdf", '"Start","E 0.0","BOOL",""\n')
        self.write("lists/two.seq", "\tA 0.0\tLamp\t\n")
        self.expect(PROBLEMS, "check", "a.awl", "lists/one.sdf")
        self.expect(GOOD, "check", "a.awl", "lists/one.sdf", "lists/two.seq")
        self.expect(GOOD, "check", "lists/two.seq", "lists/one.sdf", "a.awl")
        self.assertIn("P0709", self.expect(UNREADABLE, "check", "lists/one.sdf").err)

    def test_code_pages_of_other_countries(self):
        source = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      L     '{0}'  // {1}\n      U     \"{1}\"\nEND_ORGANIZATION_BLOCK\n"
        for name, page in (("Пуск", "cp1251"), ("启动电机", "gbk"), ("Isıtıcı", "cp1254")):
            for encoding in ("utf-8", "utf-16", "utf-16-le", page):
                with self.subTest(name=name, encoding=encoding):
                    self.write("a.awl", source.format(name[:2], name).encode(encoding))
                    self.write("a.sym", f"\"{name}\" E 0.0 BOOL\n".encode(encoding))
                    self.expect(GOOD, "check", "a.awl")


class Projects(Case):
    def test_a_project_folder(self):
        self.write("p/merker.toml", "[project]\nname = \"P\"\n[cpu]\nmodel = \"generic\"\n")
        self.write("p/a.awl", block("      U     \"Start\"\n      =     M 300.0"))
        self.write("p/names.sym", "\"Start\" E 0.0 BOOL\n")
        self.expect(GOOD, "check", "p")
        self.expect(GOOD, "check", "p/merker.toml")
        self.expect(PROBLEMS, "check", "p", "--cpu", "314C-2 PtP")

    def test_a_key_that_is_not_known(self):
        self.write("p/merker.toml", "[cpu]\nmodell = \"generic\"\n")
        self.write("p/a.awl", PROGRAM)
        err = self.expect(PROBLEMS, "check", "p").err
        self.assertRegex(err, r"^p/merker\.toml:2:1: error: .*\[P0703\]\nmodell = \"generic\"\n\^")

    def test_a_problem_in_a_symbol_file(self):
        self.write("p/merker.toml", "")
        self.write("p/a.awl", PROGRAM)
        self.write("p/a.sym", "\"Start\" E 0.0 BOOL\n\"start\" E 0.1 BOOL\n")
        self.assertIn("p/a.sym:2:", self.expect(PROBLEMS, "check", "p").err)

    def test_a_binary_file_is_called_what_it_is(self):
        self.write("p/merker.toml", "")
        self.write("p/a.awl", PROGRAM)
        for name in ("a.sym", "a.sdf"):
            self.write(f"p/{name}", bytes(range(256)))
            self.assertIn("a symbol file is a text file", self.expect(PROBLEMS, "check", "p").err)
            (self.folder / "p" / name).unlink()
        self.write("p/merker.toml", bytes(range(256)))
        self.assertIn("a project file is a text file", self.merker("check", "p").err)
