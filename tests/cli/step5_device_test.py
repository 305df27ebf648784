"""The device around a SINUMERIK's PLC as a user reaches it: NC, modules, faults, battery, coupling."""
from harness import *

TOML = '[cpu]\nmodel = "SINUMERIK 810 GA3"\n'
EMPTY = "OB 1\n : BE\n"


class Device(Case):
    def project(self, listing=EMPTY, toml="", folder="p"):
        self.write(f"{folder}/merker.toml", TOML + toml)
        self.write(f"{folder}/a.s5", listing)

    def scenario(self, steps, code=GOOD, folder="p"):
        text = "".join("  " + step.strip() + "\n" for step in steps.strip().splitlines())
        self.write(f"{folder}/s.scn", 'scenario "s"\n' + text)
        return self.expect(code, "test", folder)


MACROS = """OB 1
 : L    MB 10
 : T    MB 224
 : U    M 11.0
 : SPB  FB 56
 NAME : VORSCHUB
 : U    M 11.1
 : SPB  FB 57
 NAME : SCHLEPPA
 : U    M 11.2
 : SPB  FB 58
 NAME : SPINDIST
 : BE
"""

READ = """OB 1
 : SPA  FB 61
NAME : NCD-LESE
LESE : M 100.0
NSBY : DL 0
ANZ  : KF +1
DTY1 : KC {0}
DTY2 : KC {1}
DTY3 : KC {2}
WER1 : KF +{3}
WER2 : KF +{4}
WER3 : KF +{5}
ZFPN : KC {6}
ZIEL : KY 0,160
 : BE
"""


def read_macro(name, where, form):
    parts = (name + "      ")[:6]
    return READ.format(*(f"'{parts[i:i + 2]}'" for i in (0, 2, 4)), *where, form)


class Nc(Device):
    def test_feeds_of_fb_56(self):
        """S5-FM-12 to S5-FM-16: path and axial feed, G94, G95, G98, of both channels."""
        self.project(MACROS)
        rows = (("feed 1", "10"), ("feed_g95 2", "24"), ("feed_G98 5", "58"), ("path_feed 1", "01"),
                ("path_feed_g95 2", "06"), ("path_feed_g98 1", "09"))
        steps = "".join(f"set nc.{name} = 1425.67, MB 10 = KH 00{order}, M 11.0 = 1\nwait 3 cycles\n"
                        f"expect MW 225 = KH 675E\nexpect MW 227 = KH 4201\nset nc.{name} = 0\n" for name, order in rows)
        self.scenario(steps)

    def test_following_error_and_speed(self):
        """S5-FM-17, S5-FM-18"""
        self.project(MACROS)
        self.scenario("""set nc.following_error 3 = -70000, MB 10 = KH 0003, M 11.1 = 1
                         wait 3 cycles
                         expect MW 227 = KH FFFE
                         expect MW 225 = KH EE90
                         set nc.spindle_speed 2 = 1500, MB 10 = KH 0002, M 11.1 = 0, M 11.2 = 1
                         wait 3 cycles
                         expect MW 225 = KF +1500""")

    def test_each_type_of_fb_61(self):
        """S5-FM-42: each value that the NC holds can be given and comes to the PLC."""
        rows = (("RPNC", (1, 50, 0), "F4", "R 50", "12.345", 12345), ("RPNC", (2, 7, 0), "F4", "R 2.7", "-1", -1000),
                ("RPNC", (0, 901, 0), "F4", "R 901", "3", 3000), ("MDN", (155, 0, 0), "F0", "machine_data 155", "3", 3),
                ("MDNBY", (5002, 0, 0), "BI", "MD 5002", "165", 165), ("SEN", (4, 0, 0), "F0", "setting_data 4", "-9", -9),
                ("TOS", (0, 5, 2), "F4", "tool 5.2", "87.5", 87500), ("ZOA", (1, 2, 0), "F4", "settable_offset 1.2", "1.5", 1500),
                ("ZOA", (4, 5, 1), "F4", "settable_offset 4.5.1", "0.002", 2),
                ("ZOPR", (2, 1, 0), "F4", "programmable_offset 2.1", "7", 7000), ("ZOE", (3, 0, 0), "F4", "external_offset 3", "8", 8000),
                ("ZOPS", (1, 0, 0), "F4", "preset 1", "-4.25", -4250), ("ACPM", (4, 0, 0), "F0", "position 4", "100.5", 100500),
                ("EXBF", (2, 1, 0), "F4", "external_feed 2.1", "0.25", 250), ("PP", (1, 0, 0), "F0", "program_pointer 1.0.1", "1", 1),
                ("NCAL", (0, 0, 0), "F0", "alarm 2041", "1", 2041))
        for kind, where, form, name, value, raw in rows:
            with self.subTest(name):
                self.project(read_macro(kind, where, form))
                operand = "MW 160" if form == "BI" else "MD 160"
                self.scenario(f"""set nc.{name} = {value}
                                  expect nc.{name} = {value}
                                  set M 100.0 = 1
                                  wait 300ms
                                  expect mode = RUN
                                  expect {operand} = {raw if raw >= 0 else f"DW#16#{raw & 0xFFFFFFFF:08X}"}""")

    def test_offsets_add_up(self):
        """S5-FM-42 (ZOS, ACPW): G54 to G57 in force, G58, G59, external, PRESET."""
        self.project()
        self.scenario("""set nc.position 1 = 100, nc.settable_offset 1.1 = 1, nc.settable_offset 1.1.1 = 0.5
                         set nc.programmable_offset 1.1 = 10, nc.programmable_offset 2.1 = 20
                         set nc.external_offset 1 = 0.125, nc.preset 1 = 4, nc.settable_offset 3.1 = 7
                         expect nc.sum_offset 1 = 35.625
                         expect nc.workpiece_position 1 = 64.375
                         set nc.settable_group 1 = 3
                         expect nc.sum_offset 1 = 41.125
                         expect nc.sum_offset 2 = 0""")

    def test_written_by_the_program(self):
        """S5-FM-46: what FB 62 writes is read from outside, by value whatever its places."""
        self.project(read_macro("RPNC", (1, 50, 0), "F3").replace("FB 61", "FB 62").replace("NCD-LESE", "NCD-SCHR")
                     .replace("LESE", "SCHR").replace("ZIEL", "QUEL"))
        self.scenario("""set MW 162 = KF +12340, M 100.0 = 1
                         expect nc.R 50 = 123.4 within 300ms
                         expect nc.R 1.50 = 123.40
                         expect nc.R 50 ~= 123.40001
                         expect nc.R 50 ~= nc.R 50
                         expect nc.R 50 > 123.39
                         expect nc.R 50 < 200
                         expect nc.R 50 <> nc.R 51
                         expect nc.R 51 > -0.5""")

    def test_signals(self):
        """S5-FLAG-11, 7.1: MB 17 to MB 24."""
        self.project()
        self.scenario("""set nc.probe 2 = 1, nc.alarm 3016 = 1, nc.machining_stop = 1, nc.reloading = 90, nc.blocks 1 = 4660
                         set nc.blocks 2 = 22136, nc.ring_full = 1, nc.serial = 1
                         wait 2 cycles
                         expect MB 24 = KH 008D
                         expect MB 17 = KH 005A
                         expect MW 19 = KH 1234
                         expect MW 21 = KH 5678
                         expect MB 23 = KH 0081
                         expect nc.alarm_list 1 = 3016
                         set nc.alarm 3016 = 0, nc.probe 2 = 0, nc.probe 1 = 1, nc.ring_full = 0, nc.ring_empty = 1
                         wait 2 cycles
                         expect MB 24 = KH 0044
                         expect MB 23 = KH 0041
                         expect nc.alarm_list 1 = 0""")

    def test_everywhere(self):
        """--set, --print, --json, --watch, memory reset."""
        self.project(toml="[nc.R.1]\n50 = \"1.50\"\n")
        call = self.expect(GOOD, "run", "p", "--for", "1s", "--set", "nc.position 2 = -12.5, nc.spindle_speed 1=300", "--print",
                           "nc.R 50, nc.position 2, nc.spindle_speed 1", "--trace", "t.csv", "--watch", "nc.R 50, MB 0")
        self.assertEqual(call.lines, ["nc.R 50 = 1.50", "nc.position 2 = -12.500", "nc.spindle_speed 1 = 300"])
        document = self.expect(GOOD, "run", "p", "--cycles", "1", "--json", "--print", "nc.R 50").json
        self.assertEqual(document["nc.R 50"], 1.5)
        self.scenario("""set nc.R 50 = 2
                         memory reset
                         run
                         expect nc.R 50 = 1.5""")

    def test_trace(self):
        listing = read_macro("RPNC", (1, 50, 0), "F1").replace("FB 61", "FB 62").replace("NCD-LESE", "NCD-SCHR") \
            .replace("LESE", "SCHR").replace("ZIEL", "QUEL")
        self.project(listing)
        self.expect(GOOD, "run", "p", "--for", "1s", "--set", "M 100.0 = 1, MW 162 = KF +42", "--trace", "t.csv", "--watch",
                    "nc.R 50")
        self.assertRegex(self.read("t.csv"), r"^0\.\d{7},nc\.R 50,42\n$")

    def test_settings(self):
        """[nc] has the names of the operands."""
        self.project(MACROS, """[nc]
[nc.path_feed]
1 = "300"
[nc.feed_g98]
2 = "12.5"
[nc.settable_offset.1]
2 = "1.5"
3 = 1500
[nc.settable_offset.2.5]
1 = "-0.25"
[nc.preset]
1 = 250
[nc.program_pointer.1.0]
1 = 1
2 = 4711
[nc.probe]
1 = 1
""")
        self.scenario("""expect nc.path_feed 1 = 300
                         expect nc.feed_g98 2 = 12.5
                         expect nc.settable_offset 1.2 = 1.5
                         expect nc.settable_offset 1.3 = 1.5
                         expect nc.settable_offset 2.5.1 = -0.25
                         expect nc.preset 1 = 0.25
                         expect nc.program_pointer 1.0.2 = 4711
                         wait 1 cycles
                         expect M 24.6 = 1""")
        for wrong in ("[nc.path_feed]\n3 = \"1\"\n", "[nc.preset]\n1 = \"0.0001\"\n", "[nc.settable_offset]\n1 = 5\n",
                      "[nc.alarm]\n1 = 1\n", "[nc.program_pointer.1.0]\n1 = 3\n"):
            with self.subTest(wrong):
                self.project(toml=wrong)
                self.expect(PROBLEMS, "check", "p")

    def test_unknown_names(self):
        """One clear message with what is known."""
        self.project()
        for text, known in (("nc.speed 1", "nc.spindle_speed"), ("nc.tool 100.2", "nc.tool 1..99.0..15 (D.P)"),
                            ("nc.R 500", "nc.R 1..2.0..499"), ("nc.position", "nc.position 1..5 (axis)"), ("nc.", "nc.R, nc.tool"),
                            ("nc.R 1.2.3", "nc.R 0.900..999"), ("nc.R 900.0", "nc.R")):
            with self.subTest(text):
                call = self.expect(USAGE, "run", "p", "--for", "1s", "--print", text)
                self.assertIn("P1154", call.err)
                self.assertIn(known, call.err)

    def test_wrong_values(self):
        self.project()
        for step, reason in (("set nc.settable_group 1 = 5", "whole numbers from 1 to 4"), ("set nc.R 1 = 123456789", "eight digits"),
                             ("set nc.sum_offset 1 = 1", "only read"), ("set nc.spindle_speed 1 = 1.5", "whole numbers"),
                             ("set nc.position 1 = 0.0005", "three places"), ("set nc.feed 1 = -1", "from 0 on"),
                             ("set nc.R 1 = KF +5", "P0960"), ("set nc.R 1 = 1.123456789", "P0960"), ("expect nc.R 1 = MW 10", "P0960"),
                             ("force nc.R 1 = 1", "cannot be forced"), ("set nc.R 1 = --1", "P0960")):
            with self.subTest(step):
                call = self.scenario(step, PROBLEMS)
                self.assertIn(reason, call.out + call.err)


class Options(Device):
    def test_exchange_not_enabled(self):
        """S5-FM-34: error 8 without the option; no number of an interface byte."""
        for name, macro in (("NCD-LESE", 61), ("NCD-SCHR", 62)):
            listing = read_macro("RPNC", (1, 50, 0), "F0")
            if macro == 62:
                listing = listing.replace("FB 61", "FB 62").replace("NCD-LESE", name).replace("LESE", "SCHR").replace("ZIEL", "QUEL")
            self.project(listing, "[plc]\nnc_data_exchange = false\n")
            out = self.expect(FAULT, "diag", "p", "--for", "1s").out
            self.assertIn("6114", out)
            self.assertRegex(out, rf"AKKU1:\s+0000 {macro:04X}\s+AKKU2:\s+0000 0008")

    def test_macros_that_there_are(self):
        """S5-FM-02: these ten; FB 56 to 58 only with a G; FB 80 needs an option: 6105."""
        resident = (11, 56, 57, 58, 60, 61, 62, 65, 66, 190)
        call = " : SPA FB {0}\n"
        for number in (10, 11, 12, 40, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 80, 88, 100, 104, 189, 190, 191):
            self.project("OB 1\n" + call.format(number) + " : BE\n")
            err = self.merker("run", "p", "--for", "200ms").err
            self.assertEqual("P1123" in err, number not in resident, number)
            self.assertNotIn("STOP: 6105", err)
        for number in (56, 57, 58):
            self.project("OB 1\n" + call.format(number) + " : BE\n", "[plc]\nactual_value_macros = false\n")
            self.assertIn("6105", self.expect(FAULT, "run", "p", "--for", "1s").err)

    def test_tools_of_a_g(self):
        """S5-FM-42: P numbers to 15 with a G, to 9 with T, M and N."""
        for kind, mode in (("G", "0"), ("T", "1")):
            self.project(read_macro("TOS", (0, 5, 12), "F4"), f'[plc]\ntechnology = "{kind}"\n')
            self.scenario(f"""set M 100.0 = 1
                              wait 300ms
                              expect DB36.D 0.15 = {mode}
                              expect mode = RUN""")

    def test_order_of_md_2003(self):
        """S5-MD-04, OP-09: 1.3.4 and 9.4.13 against table 7.3."""
        listing = "OB 1\n : SPA FB 5\n : BE\nFB 5\nNAME : X\n : L KB 5\n : LIR 0\n : BE\n"
        for order, bit in (("table", 4), ("text", 5)):
            other = 9 - bit
            toml = f'[plc]\nmd_2003 = "{order}"\n[machine_data]\n2003 = '
            self.project(listing, toml + f"{1 << bit}\n")
            self.assertNotIn("6115", self.merker("run", "p", "--for", "200ms").err)
            self.project(listing, toml + f"{1 << other}\n")
            self.assertIn("6115", self.expect(FAULT, "run", "p", "--for", "200ms").err)
        slow = "OB 1\n : L KF +15000\n : T MW 100\n : SPA FB 5\n : BE\nFB 5\nNAME : X\nM1 : L MW 100\n : ADD KF -1\n : T MW 100\n" \
               " : L KF 0\n : ><F\n : SPB =M1\n : BE\n"
        for order, bits, stops in (("table", 2, True), ("table", 1, False), ("text", 1, True), ("text", 2, False)):
            self.project(slow, f'[plc]\nmd_2003 = "{order}"\n[machine_data]\n2003 = {bits}\n')
            self.assertEqual("6159" in self.merker("run", "p", "--for", "500ms").err, stops, (order, bits))


class Alarms(Device):
    def alarm(self, number, steps, listing=EMPTY, toml="", stop=True):
        """The alarm comes; in STOP its number stands at F001 too."""
        self.project(listing, toml)
        self.scenario(steps + f'\nexpect diagnostics contains "{number}" within 200ms\nexpect mode = {"STOP" if stop else "RUN"}')

    def test_modules_at_the_start(self):
        """S5-ERR-19: 6100, 6125 to 6128."""
        module = "[[module]]\n"
        rows = ((6100, module + 'input = 0\nbytes = 8\n' + module + "output = 0\nfitted = false\n"),
                (6125, module + "input = 0\nbytes = 8\n" + module + "input = 7\n"),
                (6126, module + "input = 0\nbytes = 8\n" + module + "output = 4\nbytes = 4\n" + module + "output = 0\nbytes = 5\n"),
                (6128, module + "input = 60\nbytes = 5\n"))
        for number, toml in rows:
            with self.subTest(number):
                self.alarm(number, "", toml=toml)
                out = self.expect(FAULT, "diag", "p", "--for", "1s").out
                self.assertIn(f"F001 {number}", out)
                self.assertIn("EAADFE=1", out)
        toml = "[machine_data]\n2002 = 0\n" + module + "input = 0\nbytes = 7\n"
        self.alarm(6127, "", EMPTY + "OB 2\n : BE\n", toml)
        self.assertIn("F004 0007", self.expect(FAULT, "diag", "p", "--for", "1s").out)

    def test_module_pulled(self):
        """S5-ERR-13: 6158 with the image, then 6100 at the next start; in again all is well."""
        toml = '[[module]]\nname = "Panel"\ninput = 0\nbytes = 8\n[[module]]\noutput = 4\nbytes = 2\n'
        self.alarm(6158, "wait 2 cycles\nfault Panel removed", toml=toml)
        self.scenario("""fault "AB 5" removed
                         expect mode = STOP within 200ms
                         expect diagnostics contains "6158"
                         cold restart
                         expect mode = STOP
                         expect diagnostics contains "6100"
                         fault "AB 5" removed off
                         cold restart
                         expect mode = RUN""")

    def test_direct_access(self):
        """S5-ERR-13, S5-ERR-14: 6154, opcode, kind of access and byte."""
        toml = "[[module]]\ninput = 0\nbytes = 8\n"
        self.alarm(6154, "", "OB 1\n : L PB 40\n : BE\n", toml)
        out = self.expect(FAULT, "diag", "p", "--for", "1s").out
        for words in ("F000 009A", "F001 6154", "F003 000E", "F004 0040", "LPTP=1"):
            self.assertIn(words, out)

    def test_distributed_unit(self):
        """S5-ERR-02, S5-MD-05: 6138, 6139, 6147 as MD 2003 bit 2 says, 6148 always a message."""
        rows = ((6138, "silent", "0001"), (6138, "mains", "0001"), (6139, "transmission", "0002"), (6147, "changed", "0008"))
        for number, kind, bit in rows:
            for md, stop in ((4, True), (0, False)):
                with self.subTest(kind, stop=stop):
                    more = "" if stop else f"wait 2 cycles\nexpect DB1.DW 8 = KH {bit}\nexpect M 8.0 = 1"
                    self.alarm(number, f"fault unit {kind}\n" + more, toml=f"[machine_data]\n2002 = 17\n2003 = {md}\n", stop=stop)
        self.alarm(6148, "fault unit temperature\nwait 2 cycles\nexpect DB1.DW 8 = KH 0004\nfault unit temperature off\nwait 2 cycles"
                         "\nexpect mode = RUN", toml="[machine_data]\n2002 = 17\n2003 = 7\n", stop=False)
        self.project(toml="[machine_data]\n2002 = 1\n2003 = 7\n")  # no unit is connected
        self.scenario("fault unit silent\nwait 5 cycles\nexpect mode = RUN\nexpect DB1.DW 8 = 0")

    def test_memory_and_jumpers(self):
        """S5-MEM-10, S5-ERR-19: 6122, 6124, 6130, 6133, 6137."""
        self.alarm(6122, "fault jumpers wrong\nwait 2 cycles", stop=False)
        for number, words in ((6124, "memory gap"), (6124, "memory program missing"), (6124, "memory data missing"),
                              (6130, "EPROM synchronisation"), (6133, "EPROM block"), (6137, "EPROM checksum")):
            with self.subTest(words):
                self.alarm(number, f"fault {words}\nwait 2 cycles\nexpect mode = RUN\ncold restart")
                self.scenario(f"fault {words}\ncold restart\nexpect mode = STOP\nfault {words} off\ncold restart\nexpect mode = RUN")

    def test_unknown_fault(self):
        self.project(toml='[[module]]\nname = "Panel"\ninput = 0\n')
        for step in ("fault unit asleep", "fault Box removed", "fault Panel asleep", 'fault "EB 1" removed'):
            call = self.scenario(step, PROBLEMS)
            self.assertIn("there are unit silent", call.out)
            self.assertIn('"Panel" removed', call.out)
        self.assertIn("no coupled control", self.scenario("fault coupling memory", PROBLEMS).out)
        self.assertIn("no coupled control", self.scenario("partner stop", PROBLEMS).out)
        self.assertIn("P1155", self.scenario("set partner.MB 10 = 1", PROBLEMS).err)
        for wrong in ("[[module]]\n", "[[module]]\ninput = 0\noutput = 1\n", "[[module]]\ninput = 200\n", "[[module]]\ninput = 1\nslot = 4\n"):
            self.project(toml=wrong)
            self.expect(PROBLEMS, "check", "p")


class Battery(Device):
    LISTING = """OB 20
 : U M 3.0
 : = M 200.0
 : A DB 10
 : L DW 1
 : ADD KF +1
 : T DW 1
 : BE
OB 1
 : L MW 102
 : ADD KF +1
 : T MW 102
 : BE
DB 10
 0 : KF = +5
 1 : KF = +0
"""
    FB_STARTS = LISTING.replace(" : L DW 1\n : ADD KF +1\n : T DW 1\n", " : SPA FB 5\n") \
        .replace(" : L MW 102\n : ADD KF +1\n : T MW 102\n", " : SPA FB 6\n") + \
        "FB 5\nNAME : X\n : L DW 1\n : ADD KF +1\n : T DW 1\n : BE\nFB 6\nNAME : Y\n : L MW 102\n : ADD KF +1\n : T MW 102\n : BE\n"

    def test_what_power_takes(self):
        """S5-MEM-09, 9.1 note 2: data blocks and NC data stay, images, flags, timers and counters do not."""
        self.project(self.FB_STARTS)
        self.scenario("""wait 5 cycles
                         set DB10.DW 0 = KF +77, nc.R 50 = 12.5, nc.tool 3.1 = 4
                         expect MW 102 > 4
                         power off
                         wait 1s
                         power on
                         wait 1 cycles
                         expect mode = RUN
                         expect DB10.DW 0 = KF +77
                         expect DB10.DW 1 = KF +2
                         expect nc.R 50 = 12.5
                         expect nc.tool 3.1 = 4
                         expect MW 102 < 4
                         expect M 200.0 = 1""")

    def test_warm_restart(self):
        """S5-OB-02, S5-MD-T2: MD 2003 bit 3."""
        self.project(self.FB_STARTS, "[machine_data]\n2003 = 11\n")
        self.scenario("""wait 5 cycles
                         power off
                         power on
                         wait 1 cycles
                         expect mode = RUN
                         expect M 200.0 = 0""")

    def test_battery_low(self):
        """S5-FLAG-11, 8.2: M 24.1 and UAMK bit 2 while it runs; without power the user memory is lost."""
        self.project(self.FB_STARTS)
        self.scenario("""battery low
                         wait 2 cycles
                         expect M 24.1 = 1
                         expect mode = RUN
                         battery good
                         wait 2 cycles
                         expect M 24.1 = 0
                         set DB10.DW 0 = KF +77
                         power off
                         power on
                         wait 1 cycles
                         expect DB10.DW 0 = KF +77
                         set nc.R 50 = 1
                         battery low
                         power off
                         power on
                         expect mode = STOP
                         expect diagnostics contains "user memory lost"
                         expect nc.R 50 = 0
                         cold restart
                         expect mode = STOP
                         memory reset
                         run
                         wait 1 cycles
                         expect mode = RUN
                         expect DB10.DW 0 = KF +5""")


class Card(Device):
    """9.1 note 2: the battery keeps the user memory; the end of the process is a power failure (docs/formats/card.md)."""
    LISTING = """OB 20
 : U M 3.0
 : = M 200.0
 : BE
OB 1
 : SPA FB 5
NAME : COUNT
 : BE
FB 5
NAME : COUNT
 : A DB 10
 : L DW 0
 : ADD KF +{step}
 : T DW 0
 : T MW 102
 : L KF +3
 : T DW 1
 : U M 100.7
 : SPB PB 6
 : BE
DB 10
 0 : KF = +{start}
 1 : KF = +0
DB 11
 0 : KF = +{other}
"""

    def setUp(self):
        super().setUp()
        self.program()

    def program(self, start=5, step=1, other=8, toml=""):
        self.project(self.LISTING.format(start=start, step=step, other=other), toml)

    def run_card(self, *arguments, code=GOOD, path=("p",)):
        values = self.expect(code, "run", *path, "--card", "card", "--cycles", "3", *arguments, "--json", "--print",
                             "DB10.DW 0, M 200.0, MW 102, DB11.DW 0").json
        return values["DB10.DW 0"], values["M 200.0"], values["MW 102"], values["DB11.DW 0"]

    def test_goes_on(self):
        self.assertEqual(self.run_card(), (8, True, 8, 8))
        self.assertEqual(self.run_card("--set", "DB11.DW 0 = KF +99"), (11, True, 11, 99))
        self.assertEqual(self.run_card(), (14, True, 14, 99))
        self.assertEqual(self.run_card(path=()), (17, True, 17, 99))

    def test_warm_restart_where_it_is_allowed(self):
        self.program(toml="[machine_data]\n2003 = 11\n")
        self.assertEqual(self.run_card()[:2], (8, True))
        self.assertEqual(self.run_card()[:2], (11, False))
        self.run_card("--set", "M 100.7 = 1", code=FAULT)
        self.assertEqual(self.run_card()[1], True)  # it was in STOP

    def test_another_program(self):
        """Blocks that differ are loaded; the others keep their values."""
        self.run_card("--set", "DB11.DW 0 = KF +99")
        self.program(step=10)
        self.assertEqual(self.run_card(), (38, True, 38, 99))
        self.program(step=10, other=4)
        self.assertEqual(self.run_card(), (68, True, 68, 4))
        self.program(step=10, other=4, start=100)
        self.assertEqual(self.run_card()[0], 130)
        self.write("p/a.s5", self.LISTING.format(start=100, step=10, other=4).split("DB 11")[0])
        call = self.expect(PROBLEMS, "run", "p", "--card", "card", "--cycles", "1", "--print", "DB11.DW 0")
        self.assertIn("there is no DB 11", call.err)

    def test_data_of_the_nc(self):
        arguments = ("--card", "card", "--cycles", "1", "--print", "nc.R 50, nc.tool 99.15, nc.MD 4999, nc.settable_offset 4.5.1, nc.preset 5")
        self.program(toml='[nc.R.1]\n50 = "7"\n')
        self.assertEqual(self.expect(GOOD, "run", "p", *arguments).lines[0], "nc.R 50 = 7")
        self.expect(GOOD, "run", "p", *arguments, "--set", "nc.R 50 = -1.25, nc.tool 99.15 = 3, nc.MD 4999 = -7"
                    ", nc.settable_offset 4.5.1 = 0.5, nc.preset 5 = 9")
        kept = ["nc.R 50 = -1.25", "nc.tool 99.15 = 3", "nc.MD 4999 = -7", "nc.settable_offset 4.5.1 = 0.500", "nc.preset 5 = 9.000"]
        self.assertEqual(self.expect(GOOD, "run", "p", *arguments).lines, kept)
        self.assertEqual(self.expect(GOOD, "run", *arguments).lines, kept)
        self.program(toml='[nc.R.1]\n50 = "8"\n')  # another merker.toml is loaded
        self.assertEqual(self.expect(GOOD, "run", "p", *arguments).lines[0], "nc.R 50 = 8")

    def test_blocks_that_the_program_makes(self):
        self.project("OB 1\n : SPA FB 11\nNAME : EINR-DB\nDBAN : KY 50,1\nDWNR : KF +3\n : BE\n")
        arguments = ("run", "p", "--card", "card", "--cycles", "2", "--print", "DB50.DW 3")
        self.expect(GOOD, *arguments)
        self.expect(GOOD, *arguments[:-2], "--set", "DB50.DW 3 = KF +6")
        self.assertEqual(self.expect(GOOD, *arguments).lines, ["DB50.DW 3 = W#16#0006"])

    def test_not_for_everyone(self):
        self.run_card()
        self.write("a.awl", PROGRAM)
        for program in (("p",), ()):  # of a project, and the one that is on the card
            call = self.expect(USAGE, "run", *program, "--card", "card", "--cycles", "1", "--copy-ram-to-rom")
            self.assertIn("SINUMERIK 810 GA3 has no load memory beside its RAM", call.err)
        self.expect(GOOD, "run", "a.awl", "--card", "card", "--cycles", "1")  # another model: it is loaded anew
        self.assertEqual(self.run_card()[0], 8)

    def test_doctored(self):
        """Checksums are right, what they guard is not: P1003."""
        import sqlite3, zlib
        for kind, number, cut in (("M", 0, 3), ("DB", 0x5006, 1), ("DB", 0x5005, None)):
            with self.subTest(number):
                self.expect(GOOD, "run", "p", "--card", f"card{number}", "--cycles", "1")
                base = sqlite3.connect(self.folder / f"card{number}" / "card.sqlite")
                length, = base.execute("SELECT length FROM area WHERE kind=? AND number=?", (kind, number)).fetchone()
                if cut is None:
                    base.execute("DELETE FROM area WHERE kind=? AND number=?", (kind, number))
                    base.execute("DELETE FROM page WHERE kind=? AND number=?", (kind, number))
                else:
                    page, data = base.execute("SELECT page, bytes FROM page WHERE kind=? AND number=? ORDER BY page DESC",
                                              (kind, number)).fetchone()
                    data = data[:-cut]
                    base.execute("UPDATE page SET bytes=?, checksum=? WHERE kind=? AND number=? AND page=?",
                                 (data, zlib.crc32(data), kind, number, page))
                    base.execute("UPDATE area SET length=? WHERE kind=? AND number=?", (length - cut, kind, number))
                base.execute("DELETE FROM setting WHERE name = 'contents'")
                base.execute("PRAGMA user_version = 1")  # of format 1: no sum of what belongs together
                base.commit()
                base.close()
                call = self.expect(UNREADABLE, "run", "p", "--card", f"card{number}", "--cycles", "1")
                self.assertIn("P1003", call.err)


def transfer(place, order, message):
    return f" : SPA FB 190\nNAME : K-LEITPC\nADPR : KF 0\nDBDW : KY {place}\nR/A  : KY {order}\nMELD : {message}\n"


WORDS = "".join(f" {n} : KF = +0\n" for n in range(40))


class Coupling(Device):
    def setUp(self):
        super().setUp()
        self.project("OB 1\n" + transfer("33,1", "0,10", "AB 20") + transfer("33,20", "1,5", "AB 21") + " : BE\nDB 33\n" + WORDS,
                     '[coupling]\npartner = "../master"\n', "control")
        self.project("OB 1\n" + transfer("45,1", "1,10", "AB 20") + transfer("45,20", "0,5", "AB 21") + " : BE\nDB 45\n" + WORDS,
                     '[coupling]\npartner = "../control"\nrole = "master"\n', "master")

    def test_blocks_both_ways(self):
        """S5-FM-50, S5-FM-52, S5-FM-53"""
        self.scenario("""set DB33.DW 1 = KF +11, DB33.DW 10 = KF +20, DB33.DW 11 = KF +21
                         set partner.DB45.DW 20 = KF +200, partner.DB45.DW 24 = KF +204
                         wait 4 cycles
                         expect A 20.0 = 1
                         expect AB 20 = 255
                         expect AB 21 = KF +255
                         expect partner.AB 20 = 255
                         expect partner.DB45.DW 1 = KF +11
                         expect partner.DB45.DW 10 = KF +20
                         expect partner.DB45.DW 11 = KF +0
                         expect DB33.DW 20 = KF +200
                         expect DB33.DW 24 = KF +204""", folder="control")

    def test_master_stops(self):
        """S5-FM-54: 6163, D 8.11, M 8.0; the control goes on. It is told once, again after the next failure."""
        self.scenario("""wait 2 cycles
                         expect partner mode = RUN
                         expect M 8.0 = 0
                         partner stop
                         wait 2 cycles
                         expect partner mode = STOP
                         expect partner diagnostics contains "6149"
                         expect mode = RUN
                         expect diagnostics contains "6163"
                         expect DB1.D 8.11 = 1
                         expect M 8.0 = 1
                         set M 8.0 = 0
                         wait 3 cycles
                         expect M 8.0 = 0
                         partner run
                         wait 2 cycles
                         partner power off
                         wait 2 cycles
                         expect M 8.0 = 1""", folder="control")

    def test_master_s_view(self):
        """The control's STOP is nothing that the master's operating system knows."""
        self.scenario("""wait 2 cycles
                         expect partner.AB 20 = 255
                         partner stop
                         wait 5 cycles
                         expect mode = RUN
                         expect M 8.0 = 0
                         stop
                         partner run
                         wait 200ms
                         expect partner.M 8.0 = 1
                         expect partner diagnostics contains "6163" """, folder="master")

    def test_interface(self):
        """S5-FM-52 message 1, and 6151 when the coupling memory does not answer."""
        self.scenario("""fault coupling interface
                         wait 2 cycles
                         expect AB 20 = 1
                         expect partner.AB 21 = 1
                         fault coupling interface off
                         wait 2 cycles
                         expect AB 20 = 255
                         fault coupling memory
                         expect mode = STOP within 200ms
                         expect diagnostics contains "6151" """, folder="control")

    def test_partner_is_needed(self):
        for toml, words in (('[coupling]\npartner = "../nowhere"\n', "P0101"), ("[coupling]\n", "P0744"),
                            ('[coupling]\npartner = "../s7"\n', "P0704"), ('[coupling]\npartner = "../broken"\n', "broken")):
            self.write("s7/merker.toml", '[cpu]\nmodel = "314C-2 PtP"\n')
            self.write("s7/a.awl", PROGRAM)
            self.project("OB 1\n : U E 0.9\n : BE\n", folder="broken")
            self.project(toml=toml, folder="control")
            call = self.merker("check", "control")
            self.assertNotEqual(call.code, GOOD)
            self.assertIn(words, call.err + call.out)

    def test_same_each_time(self):
        arguments = ("run", "control", "--for", "3s", "--set", "partner.DB45.DW 20 = KF +7", "--print", "DB33.DW 20, partner.AB 20")
        outs = {self.expect(GOOD, *arguments).out for _ in range(3)}
        self.assertEqual(outs, {"DB33.DW 20 = W#16#0007\npartner.AB 20 = B#16#FF\n"})


if __name__ == "__main__":
    unittest.main()
