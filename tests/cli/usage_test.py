from harness import *


class Usage(Case):
    COMMANDS = ("check", "run", "test", "list", "disassemble", "assemble", "bench")

    def test_help_of_every_command_has_an_example(self):
        overview = self.expect(GOOD, "--help").out
        for command in self.COMMANDS:
            self.assertIn(command, overview)
            self.assertIn(f"merker {command}", self.expect(GOOD, command, "--help").out)

    def test_version(self):
        self.assertRegex(self.expect(GOOD, "--version").out, r"^merker \d+\.\d+\.\d+\n$")

    def test_wrong_usage(self):
        self.write("a.awl", PROGRAM)
        for arguments in ([], ["fly"], ["check"], ["run"], ["run", "a.awl", "--nix"], ["run", "a.awl", "--for"],
                          ["run", "a.awl", "--for", "ten"], ["run", "a.awl", "--for", "1s", "--cycles", "1"],
                          ["run", "a.awl", "--cycles", "x"], ["run", "a.awl", "--cycles", "-1"],
                          ["run", "a.awl", "--for", "1s", "--engine", "steam"],
                          ["run", "a.awl", "--for", "1s", "--set", "E 0.0"],
                          ["run", "a.awl", "--for", "1s", "--set", "XY 0.0 = 1"],
                          ["run", "a.awl", "--for", "1s", "--set", "MB 1 = 300"],
                          ["run", "a.awl", "--for", "1s", "--print", "MW 10, nothing"],
                          ["run", "a.awl", "--for", "1s", "--watch", "A 0.0"],
                          ["run", "a.awl", "--for", "1s", "--trace", "t.csv"],
                          ["disassemble"], ["assemble"], ["disassemble", "--mc7", "--mc5"],
                          ["disassemble", "--mc7", "--mnemonics", "fr"], ["bench", "a.awl", "--for", "x"]):
            with self.subTest(arguments):
                self.assertNotEqual(self.expect(USAGE, *arguments).err, "")

    def test_what_comes_later_says_so(self):
        self.write("a.awl", PROGRAM)
        self.assertIn("later", self.expect(USAGE, "disassemble", "--mc5").err)
        self.assertIn("later", self.expect(USAGE, "assemble", "--mc5").err)
        self.assertIn("jit", self.expect(USAGE, "run", "a.awl", "--for", "1s", "--engine", "jit").err)
        self.assertIn("jit", self.expect(USAGE, "bench", "a.awl", "--engine", "jit").err)

    def test_what_cannot_be_read(self):
        self.write("x.exe", b"MZ")
        (self.folder / "empty").mkdir()
        for command in ("check", "run", "test", "list", "bench"):
            self.expect(UNREADABLE, command, "none.awl")
        for command in ("check", "run", "list", "bench"):
            self.expect(UNREADABLE, command, "empty")
            self.expect(UNREADABLE, command, "x.exe")
        self.expect(UNREADABLE, "disassemble", "--mc7", "none.bin")
        self.expect(UNREADABLE, "assemble", "--mc7", "none.txt")

    def test_what_cannot_be_written(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "wait 1s\n")
        self.expect(UNREADABLE, "run", "a.awl", "--for", "1s", "--trace", "no/t.csv", "--watch", "A 0.0")
        self.expect(UNREADABLE, "test", "a.awl", "--junit", "no/x.xml")
        self.expect(UNREADABLE, "test", "a.awl", "--coverage", "no/x.info")
