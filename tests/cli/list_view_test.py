"""merker list --view: the networks of a program as KOP and FUP, as text, JSON and picture."""
import json
import xml.etree.ElementTree as xml

from harness import *

NETWORKS = """ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
TITLE = The worked example
      U     E 0.0;
      U     E 0.1;
      O     A 1.0;
      =     A 3.0;
NETWORK
TITLE = Exclusive
      X     E 0.0;
      X     E 0.1;
      =     A 3.1;
NETWORK
TITLE = No box
      L     EB 1;
      T     MB 1;
END_ORGANIZATION_BLOCK
"""
NO_BOX = "(AWL, statement 1 (L EB 1): the value in the accumulator belongs to no box)"


class ListView(Case):
    def view(self, *options, code=GOOD):
        self.write("main.awl", NETWORKS)
        return self.expect(code, "list", "main.awl", *options).out

    # S7-EDIT-15
    def test_the_worked_example_as_ladder(self):
        text = self.view("--view", "kop")
        self.assertIn("├──┤ ├────┤ ├──┬───( )──\n", text)
        self.assertIn("├──┤ ├─────────┘\n", text)
        self.assertIn("(FUP, which KOP cannot show)", text)
        self.assertIn("3 networks, 1 KOP, 1 FUP, 1 AWL\n", text)

    # S7-EDIT-14
    def test_the_worked_example_as_function_blocks(self):
        text = self.view("--view", "fup")
        self.assertRegex(text, r"E 0.0─┤ +│")
        self.assertRegex(text, r"A 1.0─┤ +├──┤ = │")
        self.assertIn("3 networks, 2 FUP, 1 AWL\n", text)

    # S7-EDIT-09
    def test_a_network_without_picture_says_which_statement(self):
        self.assertIn(NO_BOX, self.view("--view", "fup"))

    def test_jumps_name_the_labels_of_the_source(self):
        self.write("jumps.awl", """FUNCTION FC 1 : VOID
BEGIN
NETWORK
      U     E 0.0;
      SPBN  end;
NETWORK
      U     E 0.0;
      SPB   on;
      TAK   ;
on:   NOP   0;
NETWORK
end:  U     E 0.2;
      =     A 0.2;
END_FUNCTION
""")
        text = self.expect(GOOD, "list", "jumps.awl", "--view", "kop").out
        self.assertRegex(text, r"E 0.0 +end\n├──┤ ├─+\(JMPN\)")
        self.assertIn("\nend:\n│ E 0.2", text)
        self.assertIn("(AWL, statement 2 (SPB on): a jump must lead to the beginning of a network)", text)
        self.assertIn("\n  on: NOP 0\n", text)

    # What compiles of it would be an empty rung.
    def test_a_block_with_errors_is_shown_as_it_is_written(self):
        self.write("main.awl", """ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     "missing";
      =     A 0.1;
NETWORK
      L     "missing too";
      TAK   ;
END_ORGANIZATION_BLOCK
""")
        text = self.expect(PROBLEMS, "list", "main.awl", "--view", "kop").out
        self.assertRegex(text, r'"missing" +A 0.1\n├─+┤ ├─+\( \)')
        self.assertIn('(AWL, statement 2 (TAK): KOP and FUP have no element for this operation)', text)
        self.assertIn("2 networks, 1 KOP, 1 AWL\n", text)

    def test_english(self):
        self.assertIn(" I 0.0 ", self.view("--view", "kop", "--mnemonics", "en"))

    # S7-MNE-03: SE is an on-delay in German, an extended pulse in English
    def test_names_and_operands_are_those_of_the_source_unless_others_are_asked_for(self):
        self.write("english.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nL S5T#2S;\nSE T 1;\nEND_ORGANIZATION_BLOCK\n")
        for options, operand, name in (((), "I 0.0", "SE"), (("--mnemonics", "de"), "E 0.0", "SV")):
            text = self.expect(GOOD, "list", "english.awl", "--view", "kop", *options).out
            self.assertIn(f" {operand} ", text)
            self.assertIn(f"({name})", text)
        self.write("faulty.awl", (self.folder / "english.awl").read_text().replace("I 0.0", '"missing"'))
        self.assertIn("(SE)", self.expect(PROBLEMS, "list", "faulty.awl", "--view", "kop", "--mnemonics", "de").out)

    def test_json_has_lines_and_sentences(self):
        networks = json.loads(self.view("--view", "kop", "--json"))["networks"]
        self.assertEqual([network["view"] for network in networks], ["KOP", "FUP", "AWL"])
        self.assertEqual(networks[0]["sentences"], ["A 3.0 = E 0.0 und E 0.1, oder A 1.0"])

    def test_the_picture_is_well_formed_and_names_statements(self):
        self.view("--view", "kop", "--svg", "main.svg")
        shapes = [node.get("data-statement") for node in xml.parse(self.folder / "main.svg").iter()]
        self.assertIn("3", shapes)

    # S5-KOPFUP-01, S5-KOPFUP-10, S5-OB-20
    def test_a_listing(self):
        self.write("main.s5", """OB 1
NETZWERK 1 Lamp
      U     E 0.0
      U(
      O     E 0.1
      O     E 0.2
      )
      =     A 0.0
NETZWERK 2 Number
      L     KF +1
      T     MW 102
      BE
""")
        text = self.expect(GOOD, "list", "main.s5", "--view", "kop").out
        self.assertIn("├──┤ ├──┬──┤ ├──┬───( )──\n", text)
        self.assertIn("(AWL, statement 1 (L KF +1): the value in the accumulator", text)
        self.assertIn("2 networks, 1 KOP, 1 AWL\n", text)
        text = self.expect(GOOD, "list", "main.s5", "--view", "fup").out
        self.assertRegex(text, r"E 0.2─┤ +├──┤ +├──┤ = │")
        self.assertIn("2 networks, 1 FUP, 1 AWL\n", text)
        text = self.expect(GOOD, "list", "main.s5", "--listing").out
        self.assertRegex(text, r"O +E 0.2")

    # S7-EDIT-18: symbols in place of addresses, of blocks and their instances too
    def test_symbols(self):
        self.write("plant/merker.toml", "")
        self.write("plant/a.awl", """FUNCTION_BLOCK FB 1
VAR_INPUT
  on : BOOL;
END_VAR
BEGIN
END_FUNCTION_BLOCK
DATA_BLOCK DB 1
FB 1
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     "Start";
      U     E 0.7;
      =     A 1.0;
NETWORK
      CALL  FB 1, DB 1 (on := E 0.0);
      NOP   0;
NETWORK
      L     MW 4;
      T     MW 6;
      TAK   ;
END_ORGANIZATION_BLOCK
""")
        self.write("plant/a.sym", "Start E 0.0\nLamp A 1.0\nMixer FB 1\n\"Mixer 1\" DB 1\nSpeed MW 4 INT\n")
        text = self.expect(GOOD, "list", "plant", "--view", "fup", "--symbols").out
        for part in ('"Start"─┤', "  E 0.7─┤", '"Lamp"', '"Mixer 1"', '│ "Mixer"', '  L     "Speed"\n'):
            self.assertIn(part, text)
        self.assertNotIn("FB 1", text.replace("FB 1\n", "", 1))
        self.write("p.s5", "OB 1\n U -START\n = A 1.0\n BE\n")
        self.write("pZ0.SEQ", "\tE 1.0\tSTART\tButton\r\n".encode("cp437"))
        self.assertIn("-START─┤", self.expect(GOOD, "list", "p.s5", "--view", "fup", "--symbols").out)

    def test_a_picture_too_large_for_text(self):
        beside = "\n".join(["U(", *["O E 0.0"] * 1500, ")"])
        behind = "\n".join(["U E 0.1"] * 1500)
        self.write("main.s5", f"OB 1\n{beside}\n{behind}\n= A 0.0\nBE\n")
        text = self.expect(GOOD, "list", "main.s5", "--view", "kop").out
        self.assertIn("(AWL, statement 1 (U(): the network is too large)\n", text)
        self.assertEqual(3003, text.count("\n  "))

    def test_wrong_usage(self):
        self.view("--svg", "main.svg", code=USAGE)
        self.view("--view", "ladder", code=USAGE)
        self.view("--view", "kop", "--svg", "no/main.svg", code=UNREADABLE)


if __name__ == "__main__":
    unittest.main()
