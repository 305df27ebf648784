import s7p

from harness import *

# U E 0.0; = A 0.0; BE and a protected block: U E 0.1; = A 0.1; BE
PROGRAM = [(s7p.OB, 1, bytes.fromhex("C000D8806500"), {}), (s7p.FC, 5, bytes.fromhex("C100D8816500"), {"PASSWORD": 3})]


class Import(Case):
    def files(self, folder, files):
        for name, content in files.items():
            path = self.folder / folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        return folder

    def test_a_zip_becomes_a_project_that_runs(self):
        symbols = [{"_SKZ": "Насос".encode("cp1251"), "_OPHIST": "A       0.0", "_DATATYP": "BOOL"}]
        (self.folder / "plant.zip").write_bytes(s7p.zipped({"x/" + n: c for n, c in s7p.project(PROGRAM, symbols, "1251").items()}))
        call = self.expect(GOOD, "import", "plant.zip", "-o", "plant")
        self.assertIn("1 symbols", call.out)
        self.assertIn("FC 5 is protected", call.out)
        self.assertTrue(call.out.endswith("written to plant\n"), call.out)
        self.assertIn("FC 5 is protected", (self.folder / "plant/import-report.txt").read_text(encoding="utf-8"))
        self.assertIn("Насос", (self.folder / "plant/symbols.sym").read_text(encoding="utf-8"))
        self.assertIn("2 blocks, 0 errors", self.expect(GOOD, "check", "plant").out)
        out = self.expect(GOOD, "run", "plant", "--cycles", "10", "--set", "E 0.0 = 1", "--print", '"Насос"').out
        self.assertEqual(out, '"Насос" = 1\n')

    def test_a_folder_and_the_default_name(self):
        self.files("in/Plant", s7p.project(PROGRAM))
        self.assertIn("written to Plant", self.expect(GOOD, "import", "in/Plant").out)
        self.assertTrue((self.folder / "Plant/OB1.awl").is_file())

    def test_existing_files_are_safe(self):
        self.files("in", s7p.project(PROGRAM))
        self.write("out/mine.txt", "mine")
        call = self.expect(UNREADABLE, "import", "in", "-o", "out")
        self.assertIn("out exists and is not empty", call.err)
        self.assertEqual([p.name for p in (self.folder / "out").iterdir()], ["mine.txt"])

    def test_wrong_usage(self):
        self.files("in", s7p.project(PROGRAM))
        self.assertIn("the programs are: Line 1", self.expect(USAGE, "import", "in", "-o", "a", "--program", "Line 2").err)
        self.expect(USAGE, "import")
        self.assertIn("cannot be read", self.expect(UNREADABLE, "import", "missing").err)
        self.write("letter/letter.txt", "Dear reader")
        self.assertIn("nothing that can be imported", self.expect(UNREADABLE, "import", "letter", "-o", "b").err)
        self.assertIn("--program", self.expect(GOOD, "import", "--help").out)

    def test_nothing_leads_out_of_the_folder(self):
        files = s7p.project(PROGRAM)
        evil = {"../../evil.awl": b"FUNCTION FC 9 : VOID\r\n", "/tmp/evil2.awl": b"FUNCTION FC 9 : VOID\r\n"}
        (self.folder / "a.zip").write_bytes(s7p.zipped({**files, **evil}))
        call = self.expect(PROBLEMS, "import", "a.zip", "-o", "deep/out")
        self.assertIn("leads out of the archive", call.out)
        self.assertEqual([p for p in self.folder.rglob("*evil*")], [])

    def test_a_file_of_another_kind_is_named_and_no_loss(self):
        self.write("in/a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n")
        self.write("in/letter.pdf", "Dear reader")
        out = self.expect(GOOD, "import", "in", "-o", "out").out
        self.assertIn("Beside it, not part of a program:\n  letter.pdf is not a file", out)
        self.assertNotIn("Not imported", out)
        self.assertIn("are no loss", self.expect(GOOD, "import", "--help").out)

    def test_a_folder_that_cannot_be_written_is_one_problem(self):
        self.files("in", s7p.project(PROGRAM))
        self.write("a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n")
        for source in ("in", "a.awl"):
            call = self.expect(UNREADABLE, "import", source, "-o", "/proc/x")
            self.assertRegex(call.err, "^merker import: /proc/x cannot be written: .+\n$")
            self.assertEqual(call.out, "")

    def test_an_unknown_packing_method_is_the_reason(self):
        content = bytearray(s7p.zipped({"a.awl": b"FUNCTION FC 1 : VOID\nBEGIN\nEND_FUNCTION\n"}))
        content[8:10] = b"\x61\0"  # WavPack
        at = content.index(b"PK\1\2") + 10
        content[at:at + 2] = b"\x61\0"
        (self.folder / "odd.zip").write_bytes(content)
        call = self.expect(UNREADABLE, "import", "odd.zip", "-o", "out")
        self.assertIn("a.awl: its packing method is not supported", call.err)

    def test_a_bomb_costs_itself(self):
        bomb = b"\0" * (80 << 20)
        (self.folder / "a.zip").write_bytes(s7p.zipped({**s7p.project(PROGRAM), "hOmSave7/x/HOBJECT1.DBF": bomb}))
        call = self.expect(PROBLEMS, "import", "a.zip", "-o", "out")
        self.assertIn("packed more densely", call.out)
        self.assertTrue((self.folder / "out/OB1.awl").is_file(), call.out)

    def test_every_cut_of_a_zip_ends_with_a_message(self):
        content = s7p.zipped(s7p.project(PROGRAM))
        for length in range(0, len(content), len(content) // 12):
            with self.subTest(length):
                (self.folder / "cut.zip").write_bytes(content[:length])
                call = self.merker("import", "cut.zip", "-o", f"out{length}")
                self.assertIn(call.code, (PROBLEMS, UNREADABLE), call.err)
                text = call.out if call.code == PROBLEMS else call.err
                self.assertEqual(length > 0, "it is damaged or cut off" in text, text)

    def test_a_zip_without_its_directory_comes_whole(self):
        content = s7p.zipped(s7p.project(PROGRAM))
        (self.folder / "cut.zip").write_bytes(content[:content.index(b"PK\1\2")])
        call = self.expect(PROBLEMS, "import", "cut.zip", "-o", "out")
        self.assertIn("cut.zip, from byte", call.out)
        (self.folder / "whole.zip").write_bytes(content)
        self.expect(GOOD, "import", "whole.zip", "-o", "whole")
        for file in sorted(path.name for path in (self.folder / "whole").glob("*.awl")):
            self.assertEqual((self.folder / "out" / file).read_bytes(), (self.folder / "whole" / file).read_bytes())

    def test_a_cut_table_is_named(self):
        files = s7p.project(PROGRAM)
        name = "OMBSTX/offline/00000001/SUBBLK.DBF"
        self.files("in", {**files, name: files[name][:-20]})
        call = self.expect(PROBLEMS, "import", "in", "-o", "out")
        self.assertIn("SUBBLK.DBF is cut off: rows that its header counts are missing: 1", call.out)

    # Issue: a damaged file costs itself, not the import
    def test_every_damaged_table_leaves_the_rest(self):
        files = s7p.project(PROGRAM, [{"_SKZ": "Motor", "_OPHIST": "A 0.0"}])
        for number, name in enumerate(sorted(files)):
            for kind, damage in enumerate((b"", files[name][:40], bytes(reversed(files[name])))):
                with self.subTest(name=name, length=len(damage)):
                    folder = self.files(f"in{number}-{kind}", {**files, name: damage})
                    result = self.merker("import", folder, "-o", "out-" + folder)
                    self.assertIn(result.code, (GOOD, PROBLEMS), result.err)
                    self.assertTrue((self.folder / ("out-" + folder) / "merker.toml").is_file())
