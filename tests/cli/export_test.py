"""merker export: files of STEP 5 (docs/formats/s5d.md)."""
from harness import GOOD, PROBLEMS, UNREADABLE, USAGE, Case

LISTING = """OB 1
NETZWERK 1 Größe
 U -START ! Taster
 = A 1.0
 BE
DB 10
 0: KF +5
"""


class Export(Case):
    def setUp(self):
        super().setUp()
        self.write("p.s5", LISTING)
        self.write("pZ0.SEQ", "\tE 1.0\tSTART\tTür\r\n".encode("cp437"))

    def data(self, path):
        return (self.folder / path).read_bytes()

    def test_an_s5d_file_with_its_assignment_list(self):
        out = self.expect(GOOD, "export", "p.s5", "-o", "PUMPE@ST.S5D").out
        self.assertIn("PUMPE@Z0.SEQ", out)
        data = self.data("PUMPE@ST.S5D")
        self.assertEqual(data[8:16], b"PUMPE@ST")
        self.assertEqual(len(data) % 128, 0)
        self.assertIn(b"Gr\x94\xe1e", data)
        self.assertEqual(self.data("PUMPE@Z0.SEQ"), b"\tE 1.0\tSTART\tT\x81r\r\n")

    def test_existing_files_stay(self):
        self.write("A@@@@@ST.S5D", "mine")
        err = self.expect(UNREADABLE, "export", "p.s5", "-o", "A@@@@@ST.S5D").err
        self.assertIn("A@@@@@ST.S5D already exists; --force replaces it", err)
        self.assertEqual(self.data("A@@@@@ST.S5D"), b"mine")
        self.expect(GOOD, "export", "p.s5", "-o", "A@@@@@ST.S5D", "--force")

    def test_a_listing(self):
        self.expect(GOOD, "export", "p.s5", "-o", "out.s5", "--symbols")
        self.assertIn(b"-START", self.data("out.s5"))
        self.expect(GOOD, "export", "p.s5", "-o", "out2.s5")
        self.assertIn(b"E 1.0", self.data("out2.s5"))

    def test_what_cannot_be_written_is_told(self):
        self.assertIn("write one of .s5d, .s5, .seq", self.expect(USAGE, "export", "p.s5", "-o", "p.doc").err)
        self.write("sub/q.s5", "OB 1\n BE\n")
        self.assertIn("nothing for", self.expect(PROBLEMS, "export", "sub/q.s5", "-o", "q.seq").err)
        self.write("bad/b.s5", "OB 1\n U -NIE\n BE\n")
        self.expect(PROBLEMS, "export", "bad/b.s5", "-o", "b.s5d")
        self.assertIn("cannot write", self.expect(UNREADABLE, "export", "p.s5", "-o", "no/folder/x.s5d").err)
