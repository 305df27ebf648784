from harness import *


class Usage(Case):
    COMMANDS = ("check", "run", "test", "list", "hw", "disassemble", "assemble", "bench")

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
                          ["run", "a.awl", "--cycles", "1000000001"], ["run", "a.awl", "--cycles", "9" * 30],
                          ["run", "a.awl", "--cycles", "1.5"], ["run", "a.awl", "--cycles", ""],
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

    def test_an_unknown_cpu_lists_the_models(self):
        self.write("a.awl", PROGRAM)
        for arguments in (["check"], ["run", "--for", "1s"], ["test"], ["list"], ["bench"]):
            call = self.expect(USAGE, arguments[0], "a.awl", *arguments[1:], "--cpu", "S7-1500")
            self.assertIn("'S7-1500'", call.err)
            self.assertIn("314C-2 PtP", call.err)

    def test_an_unknown_command_lists_the_commands(self):
        call = self.expect(USAGE, "foo", "a.awl")
        self.assertIn("'foo'", call.err)
        for command in self.COMMANDS:
            self.assertIn(command, call.err)

    def test_a_number_of_cycles_says_its_limits(self):
        for text in ("-1", "1000000001", "9" * 30, "many"):
            self.assertIn("0 to 1000000000", self.expect(USAGE, "run", "a.awl", f"--cycles={text}").err)

    def test_what_comes_later_says_so(self):
        self.write("a.awl", PROGRAM)
        self.assertIn("--mc5", self.expect(USAGE, "disassemble").err)
        self.assertIn("--mc5", self.expect(USAGE, "assemble").err)

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

    def test_a_pipe_is_no_source(self):
        self.write("p/merker.toml", "")
        for name in ("f.awl", "f.scn", "p/f.awl"):
            os.mkfifo(self.folder / name)
        for command, path in (("check", "f.awl"), ("check", "p"), ("run", "f.awl"), ("test", "f.awl"), ("test", "f.scn"),
                              ("list", "f.awl"), ("bench", "f.awl")):
            self.assertIn("not a regular file", self.expect(UNREADABLE, command, path, timeout=60).err)
        for command in ("assemble", "disassemble"):
            self.assertIn("not a regular file", self.expect(UNREADABLE, command, "--mc7", "f.awl", timeout=60).err)

    def test_a_full_disk(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "wait 1s\n")
        self.write("i.txt", "U E 0.0\n")
        self.write("m.bin", b"\xC0\x00")
        for arguments in (["check", "a.awl"], ["check", "a.awl", "--json"], ["run", "a.awl", "--for", "1s", "--print", "MW 10"],
                          ["run", "a.awl", "--for", "1s", "--json"], ["test", "a.awl"], ["list", "a.awl", "--code"],
                          ["assemble", "--mc7", "i.txt"], ["disassemble", "--mc7", "m.bin"], ["bench", "a.awl", "--for", "1ms"],
                          ["--help"], ["--version"]):
            with self.subTest(arguments), open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([os.environ["MERKER"], *arguments], cwd=self.folder, stdout=full, stderr=subprocess.PIPE,
                                      encoding="utf-8", timeout=60, check=False)
                self.assertEqual(done.returncode, UNREADABLE, done.stderr)
                self.assertIn("cannot write", done.stderr)

    def test_what_cannot_be_written(self):
        self.write("a.awl", PROGRAM)
        self.write("a.scn", "wait 1s\n")
        self.expect(UNREADABLE, "run", "a.awl", "--for", "1s", "--trace", "no/t.csv", "--watch", "A 0.0")
        self.expect(UNREADABLE, "run", "a.awl", "--for", "1s", "--trace", "/dev/full", "--watch", "MW 20")
        self.expect(UNREADABLE, "test", "a.awl", "--junit", "/dev/full")
        self.expect(UNREADABLE, "test", "a.awl", "--junit", "no/x.xml")
        self.expect(UNREADABLE, "test", "a.awl", "--coverage", "no/x.info")
