"""merker import of program files of STEP 5 (docs/formats/s5d.md)."""
import zipfile

from harness import *

LISTING = """OB 1
NETZWERK 1 Größe
 U -START ! Taster
 SPB FB 7
NAME : VENTIL
EIN : E 2.0
 BE
FB 7 VENTIL
BEZ : EIN E BI
M9 : U =EIN
 = A 3.0
 SPB =M9
 BE
DB 10
 0: KF +5 ! Zahl
 1: KS 'HALLO'
"""


class ImportStep5(Case):
    def setUp(self):
        super().setUp()
        self.write("p.s5", LISTING)
        self.write("pZ0.SEQ", "\tE 1.0\tSTART\tTür\r\n\tFB 7\tVENTIL7\r\n".encode("cp437"))
        self.write("old/readme.txt", "1994")
        self.expect(GOOD, "export", "p.s5", "-o", "old/PUMPE@ST.S5D")

    def code(self, path):
        return [block["code"] for block in self.expect(GOOD, "list", path, "--code", "--json").json["blocks"]]

    def test_a_program_comes_in_as_it_went_out(self):
        out = self.expect(GOOD, "import", "old", "-o", "new").out
        self.assertIn("3 blocks of STEP 5 as listings, with 3 comments and titles", out)
        self.assertIn("2 symbols", out)
        self.assertTrue((self.folder / "new/import-report.txt").is_file())
        self.expect(GOOD, "check", "new")
        self.assertEqual(self.code("new"), self.code("p.s5"))
        text = (self.folder / "new/OB1.s5").read_text(encoding="utf-8")
        self.assertIn("NETZWERK 1 Größe", text)
        self.assertIn("U     -START", text)
        self.assertIn("KS 'HALLO '", (self.folder / "new/DB10.s5").read_text(encoding="utf-8"))
        self.expect(GOOD, "run", "new", "--for", "1s")
        self.expect(GOOD, "export", "new", "-o", "PUMPE@ST.S5D")
        first, second = ((self.folder / name).read_bytes() for name in ("old/PUMPE@ST.S5D", "PUMPE@ST.S5D"))
        self.assertEqual(first, second)

    def test_a_zip_with_two_programs(self):
        data = (self.folder / "old/PUMPE@ST.S5D").read_bytes()
        with zipfile.ZipFile(self.folder / "plant.zip", "w") as plant:
            plant.writestr("a/PUMPE@ST.S5D", data)
            plant.writestr("a/pumpe@z0.seq", b"  E 1.0     START     Taster\r\n")
            plant.writestr("b/BAND@@ST.S5D", data)
            plant.writestr("b/BAND@@Z0.INI", b"\0\1")
        out = self.expect(PROBLEMS, "import", "plant.zip").out
        self.assertIn("BAND@@Z0.INI: the compiled assignment list; it is not read", out)
        self.assertIn("-START", (self.folder / "plant/PUMPE/OB1.s5").read_text(encoding="utf-8"))
        self.assertIn("E 1.0", (self.folder / "plant/BAND/OB1.s5").read_text(encoding="utf-8"))
        self.expect(GOOD, "check", "plant/PUMPE")
        self.expect(GOOD, "import", "plant.zip", "-o", "one", "--program", "pumpe")
        self.assertTrue((self.folder / "one/OB1.s5").is_file())

    def test_damage_and_deleted_blocks_are_reported(self):
        data = bytearray((self.folder / "old/PUMPE@ST.S5D").read_bytes())
        at = data.index(b"pp\x10\x01")
        data[at + 2 * (data[at + 8] * 256 + data[at + 9]) - 2] = 0
        section = data.index(b"PUMPE@ST", 128) - 8
        data[section + 22] -= 2  # DB 10 and DK 10
        (self.folder / "old/PUMPE@ST.S5D").write_bytes(data)
        out = self.expect(PROBLEMS, "import", "old", "-o", "new").out
        self.assertIn("OB 1: it does not end with BE", out)
        self.assertIn("DB 10: a deleted version of it was found; it is in deleted/DB10.s5.txt", out)
        self.assertIn("KH", (self.folder / "new/deleted/DB10.s5.txt").read_text(encoding="utf-8"))
        self.assertFalse((self.folder / "new/OB1.s5").exists())

    def test_the_code_page(self):
        self.write("q.s5", "PB 1\n BE ! 5 × 5\n")
        self.expect(GOOD, "export", "q.s5", "-o", "QST.S5D", "--code-page", "850")
        self.expect(GOOD, "import", "QST.S5D", "-o", "q", "--code-page", "850")
        self.assertIn("5 × 5", (self.folder / "q/PB1.s5").read_text(encoding="utf-8"))
