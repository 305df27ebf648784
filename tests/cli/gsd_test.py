"""merker gsd: what GSD files say of DP slaves (docs/formats/gsd.md)."""
import json

from harness import GOOD, PROBLEMS, UNREADABLE, USAGE, Case

FILE = """; a head station
#Profibus_DP
GSD_Revision = 3
Vendor_Name = "Merker"
Model_Name = "Lämpchen"
Ident_Number = 0x7FFF
9.6_supp = 1
12M_supp = 1
Modular_Station = 1
Max_Module = 2
Max_Input_Len = 4
Max_Output_Len = 8
Ext_User_Prm_Data_Const(0) = 0x80,0x01
Module = "8 DI" 0x10
1
EndModule
Module = "Drive" 0xF1
"""


class Gsd(Case):
    def setUp(self):
        super().setUp()
        self.write("lamp.gsg", FILE.encode("cp1252"))

    def test_as_text(self):
        run = self.expect(GOOD, "gsd", "lamp.gsg")
        self.assertIn("lamp.gsg: Merker Lämpchen, ident number 0x7FFF, GSD revision 3\n", run.out)
        self.assertIn("  baud rates: 9.6, 12M\n", run.out)
        self.assertIn("  at most 2 modules, 4 bytes of inputs, 8 of outputs\n", run.out)
        self.assertIn("  parameters: 80 01\n", run.out)
        self.assertIn(f"  {'8 DI':<40}     1      0  10\n", run.out)
        self.assertIn(f"  {'Drive':<40}     4      4  F1\n", run.out)
        self.assertEqual(run.err, "lamp.gsg:17:1: warning: there is no EndModule for it\n")

    def test_as_json(self):
        document = json.loads(self.expect(GOOD, "gsd", "lamp.gsg", "lamp.gsg", "--json").out)
        self.assertEqual(len(document), 2)
        self.assertEqual(document[0]["remarks"][0]["line"], 17)
        device = document[0]["device"]
        self.assertEqual(device["ident"], 0x7FFF)
        self.assertEqual(device["parameterBytes"], [0x80, 1])
        self.assertEqual([module["configuration"] for module in device["modules"]], [[0x10], [0xF1]])
        self.assertEqual([module["input"] for module in device["modules"]], [1, 4])
        self.assertEqual(device["modules"][0]["reference"], 1)

    def test_errors(self):
        self.write("no.gsd", "just a text\n")
        self.assertEqual(self.expect(PROBLEMS, "gsd", "no.gsd").err,
                         "no.gsd: error: this is not a GSD file: the line #Profibus_DP is missing\n")
        self.write("large.gsd", FILE + ";" * 1024 * 1024)
        self.assertIn("larger than 1 MB", self.expect(UNREADABLE, "gsd", "large.gsd").err)
        self.assertIn("cannot read missing.gsd", self.expect(UNREADABLE, "gsd", "missing.gsd", "lamp.gsg").err)
        self.expect(USAGE, "gsd")
