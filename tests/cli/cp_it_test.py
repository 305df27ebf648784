"""A CP 343-1 IT (S7-NET-16): its pages over a real socket, with the state of the CPU and values of its operands; e-mails of the program to a
real mail server, read by another implementation of their format."""
import email
import email.policy
import http.client
import threading
import urllib.parse

from s7_client import *

TEXT = "Zeile eins$R$L.Zeile zwei: <\u00D6lstand> "
# M 0.0 sends DB 10 as an e-mail of MW 40 bytes; MB 10 counts those that were taken, MW 20 is the STATUS of the last other one. M 0.1 leads to a fault.
PROGRAM = f"""DATA_BLOCK DB 10
STRUCT
  addressee : STRING [60] := 'meister@plant.example; nacht@plant.example';
  sender : STRING [40] := '';
  subject : STRING [80] := '\u00D6l fehlt an der Presse, bitte nachf\u00FCllen und quittieren: Halle 3';
  text : STRING [120] := '{TEXT}';
  more : STRING [22] := 'ist zu niedrig.';
END_STRUCT
BEGIN
END_DATA_BLOCK
DATA_BLOCK DB 11
STRUCT
  name : STRING [20] := '<b>"Tom" & J';
  level : REAL := 12.5;
  count : INT := -3;
  pause : TIME := T#5S;
  start : DATE_AND_TIME := DT#1998-04-14-17:53:17.333;
END_STRUCT
BEGIN
END_DATA_BLOCK
""" + block("""L MB 90; + 1; T MB 90;
CALL FC 5 (ACT := M 0.0, ID := 5, LADDR := W#16#100, SEND := P#DB10.DBX 0.0 BYTE 332, LEN := MW 40, DONE := M 1.0, ERROR := M 1.1, STATUS := MW 50);
CALL FC 6 (ID := 5, LADDR := W#16#100, RECV := P#M 100.0 BYTE 10, NDR := M 1.2, ERROR := M 1.3, STATUS := MW 52, LEN := MW 54);
U M 1.0; SPBN a; L MB 10; + 1; T MB 10; R M 0.0;
a: U M 1.1; SPBN b; L MW 50; T MW 20; R M 0.0;
b: U M 0.1; SPBN c; L W#16#FFFF; BTI;
c: NOP 0;""")
SYMBOLS = '''"Level" MW 2 INT
"Lamp: red" A 0.0 BOOL
"Data" DB 11 DB 11
'''
PAGE = """<p>:="Level": litres, :="Lamp: red":, :=MW 2:, :=mb3:</p><p>:="Data".name: :="Data".level: :=DB11.DBW 26:</p>
<p>:="Data".pause: :="Data".start: :=T 1:</p><p>:="Levle":</p><p>:=DB 99.DBW 0:</p><p>a := b; c ::= d:</p>"""
STOP = "32 01 00 00 00 02 00 10 00 00 29 00 00 00 00 00 09 50 5F 50 52 4F 47 52 41 4D"


class MailServer:
    """Takes e-mails until it is closed. `answers`: to a command another reply than the usual one."""
    def __init__(self, **answers):
        self.mails, self.said, self.answers = [], [], answers
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.port = self.socket.getsockname()[1]
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()

    def serve(self):
        while True:
            try:
                client, _ = self.socket.accept()
            except OSError:
                return
            with client, client.makefile("rb") as lines:
                try:
                    self.talk(client, lines)
                except OSError:
                    pass  # the CP has had enough

    def talk(self, client, lines):
        client.sendall(b"220-sink\r\n220 at your service\r\n")
        while line := lines.readline():
            self.said.append(line.decode().rstrip())
            word = line[:4].decode().upper()
            reply = self.answers.get(word, {"DATA": "354 go on", "EHLO": "250-sink\r\n250 SIZE 9999"}.get(word, "250 good"))
            client.sendall(reply.encode() + b"\r\n")
            if word == "DATA":
                content = b""
                while (line := lines.readline()) != b".\r\n":
                    content += line[1:] if line.startswith(b"..") else line
                self.mails.append(content)
                client.sendall(b"250 taken\r\n")
            if word == "QUIT":
                return

    def close(self):
        self.socket.shutdown(socket.SHUT_RDWR)  # accept ends
        self.socket.close()
        self.thread.join()


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as one:
        return one.getsockname()[1]


class ItCase(S7Case):
    def plant(self, mail_port=9, pages=True):
        self.web = free_port()
        self.write("plant/a.awl", PROGRAM)
        self.write("plant/symbols.sym", SYMBOLS)
        self.write("plant/merker.toml", f"""[cpu]
model = "314C-2 DP"
[[module]]
slot = 4
type = "6GK7 343-1GX11-0XE0"
web = {{ port = {self.web}{', pages = "pages"' if pages else ''} }}
[[connection]]
kind = "e-mail"
id = 5
partner = "smtp://127.0.0.1:{mail_port}"
sender = "presse@plant.example"
""")
        (self.folder / "plant/pages").mkdir()

    def run_plant(self):
        process = self.start("plant", "--no-workbench")
        self.assertEqual(process.stderr.readline(), f"Web server of the CP in slot 4: http://127.0.0.1:{self.web}/\n")
        return process, self.client(3)

    def ask(self, target, method="GET", **headers):
        """Status, headers, text."""
        connection = http.client.HTTPConnection("127.0.0.1", self.web, timeout=20)
        self.addCleanup(connection.close)
        connection.request(method, target, headers={name.replace("_", "-"): value for name, value in headers.items()})
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read().decode()

    def page(self, target):
        status, _, text = self.ask(target)
        self.assertEqual(status, 200)
        return text


class Pages(ItCase):
    def test_the_state_of_the_cpu(self):
        self.plant(pages=False)
        process, client = self.run_plant()
        page = self.page("/")  # nobody has made another first page
        for part in ("CPU 314C-2 DP", "6ES7 314-6CF01-0AB0", "<td>RUN</td>", 'http-equiv="refresh"', "Diagnostic buffer"):
            self.assertIn(part, page)
        state = json.loads(self.page("/cpu.json"))
        self.assertEqual((state["mode"], state["leds"]["RUN"], state["leds"]["SF"], state["stopReason"]), ("RUN", "on", "off", ""))
        client.write(FLAGS, 0, b"\x02")
        self.until(lambda: json.loads(self.page("/cpu.json"))["mode"] == "STOP")
        state = json.loads(self.page("/cpu.json"))
        self.assertEqual((state["leds"]["RUN"], state["leds"]["STOP"], state["leds"]["SF"]), ("off", "on", "on"))
        self.assertIn("2521", " ".join(entry["event"] for entry in state["diagnostics"]))
        page = self.page("/cpu.html")
        self.assertIn("<td>STOP</td>", page)
        self.assertIn("Cause of STOP", page)
        self.end(process)

    def test_the_pages_of_the_user(self):
        self.plant()
        self.write("plant/pages/index.html", PAGE)
        self.write("plant/pages/values.json", '{"level": :="Level":, "name": ":="Data".name:", "none": :="Levle":}')
        self.write("plant/pages/sub/a b.css", "p { color: red } /* :=MW 2: */")
        process, client = self.run_plant()
        client.write(FLAGS, 2, b"\x04\xD2")
        lines = self.page("/").split("\n")
        self.assertEqual(lines[0], "<p>1234 litres, 0, 1234, 210</p><p>&lt;b&gt;&quot;Tom&quot; &amp; J 12.5 65533</p>")
        self.assertEqual(lines[1], "<p>T#5S DT#1998-04-14-17:53:17.333 S5T#0MS</p><p>[symbol &quot;Levle&quot; is not in the symbol table]</p>"
                         "<p>[DB 99.DBW 0 does not exist: there is no DB 99]</p><p>a := b; c ::= d:</p>")
        self.assertEqual(json.loads(self.page("/values.json")), {"level": 1234, "name": '<b>"Tom" & J', "none": None})
        client.write(FLAGS, 2, b"\xFF\xFE")
        self.assertEqual(json.loads(self.page("/values.json?2"))["level"], -2)
        status, headers, text = self.ask("/sub/a%20b.css")
        self.assertEqual((status, headers["Content-Type"], text), (200, "text/css; charset=utf-8", "p { color: red } /* :=MW 2: */"))
        status, headers, text = self.ask("/", "HEAD")
        self.assertEqual((status, text, headers["Cache-Control"]), (200, "", "no-store"))
        self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
        self.assertIn("RUN", self.page("/cpu.html"))
        # In STOP, too: the CP has its own processor.
        client.ask(STOP)
        self.assertEqual(json.loads(self.page("/values.json"))["level"], -2)
        self.end(process)

    def test_what_is_refused(self):
        self.plant()
        self.write("plant/pages/.hidden.html", "no")
        self.write("plant/pages/large.txt", "x" * (1 << 20) + "x")
        self.write("plant/pages/good.txt", "x" * (1 << 20))
        self.write("plant/secret.html", "no")
        (self.folder / "plant/pages/link.html").symlink_to("../secret.html")
        process, _ = self.run_plant()
        self.assertEqual(len(self.page("/good.txt")), 1 << 20)
        for target in ("/../secret.html", "/%2e%2e/secret.html", "/..%5csecret.html", "/sub/../../secret.html", "/link.html", "/.hidden.html",
                       "/large.txt", "/none.html", "//etc/passwd", "/%zz", "/sub", "/" + urllib.parse.quote("a\0b")):
            self.assertEqual(self.ask(target)[0], 404, target)
        self.assertEqual(self.ask("/good.txt", "POST")[0], 405)
        self.assertEqual(self.ask("/good.txt", Host="evil.example")[0], 421)
        self.assertEqual(self.ask("/good.txt", Origin="http://evil.example")[0], 403)
        self.assertEqual(self.ask("/" + "x" * 20_000)[0], 431)
        with socket.create_connection(("127.0.0.1", self.web), timeout=20) as stranger:
            stranger.sendall(b"\x16\x03\x01 nonsense\r\n\r\n")
            self.assertIn(b"400 Bad Request", stranger.recv(1000))
        # Whoever says nothing keeps nobody out.
        silent = [socket.create_connection(("127.0.0.1", self.web), timeout=20) for _ in range(100)]
        self.assertEqual(self.ask("/good.txt")[0], 200)
        for one in silent:
            one.close()
        self.end(process)

    def test_a_port_that_is_taken(self):
        self.plant()
        with socket.create_server(("127.0.0.1", self.web)):
            process = self.start("plant", "--no-workbench")
            self.assertRegex(process.stderr.readline(), rf"web server of the CP in slot 4: port {self.web} of 127\.0\.0\.1 cannot be used")
        self.assertIn("Web server of the CP in slot 4", process.stderr.readline())  # it tries again
        self.assertEqual(self.ask("/cpu.json")[0], 200)
        self.end(process)


class Mails(ItCase):
    def send(self, client, length=332):
        self.until(lambda: client.read(FLAGS, 0) == b"\0")
        client.write(FLAGS, 40, struct.pack(">H", length))
        client.write(FLAGS, 0, b"\x01")
        self.until(lambda: client.read(FLAGS, 0) == b"\0")

    def begin(self, **answers):
        server = MailServer(**answers)
        self.plant(server.port)
        process, client = self.run_plant()
        self.until(lambda: client.read(FLAGS, 52, 2) == b"\x81\x80")  # nothing comes, but the CP is there
        return server, process, client

    def test_an_email(self):
        server, process, client = self.begin()
        self.send(client)
        self.assertEqual((client.read(FLAGS, 10), client.read(FLAGS, 20, 2)), (b"\x01", b"\0\0"))
        self.assertEqual(server.said[0], "EHLO [127.0.0.1]")
        self.assertEqual(server.said[1:4], ["MAIL FROM:<presse@plant.example>", "RCPT TO:<meister@plant.example>", "RCPT TO:<nacht@plant.example>"])
        mail = email.message_from_bytes(server.mails[0], policy=email.policy.default)
        self.assertEqual(mail["Subject"], "\u00D6l fehlt an der Presse, bitte nachf\u00FCllen und quittieren: Halle 3")
        self.assertEqual((mail["From"], mail["To"]), ("presse@plant.example", "meister@plant.example, nacht@plant.example"))
        self.assertEqual(mail.get_content().splitlines(), ["Zeile eins", ".Zeile zwei: <\u00D6lstand> ist zu niedrig."])
        self.assertFalse(mail.defects)
        self.assertIsNotNone(email.utils.parsedate_to_datetime(mail["Date"]))
        self.assertTrue(all(len(line) <= 76 and line.isascii() for line in server.mails[0].split(b"\r\n")))
        # Another sender, plain text with a point at its begin.
        for place, text in ((62, "einer@plant.example"), (104, "plain"), (186, ".")):
            client.write(DATA_AREA, place + 1, bytes([len(text)]) + text.encode(), BYTE, 10)
        self.send(client)
        self.assertEqual(client.read(FLAGS, 10), b"\x02")
        mail = email.message_from_bytes(server.mails[1], policy=email.policy.default)
        self.assertEqual((mail["From"], mail["Subject"], mail.get_content().rstrip("\r\n")), ("einer@plant.example", "plain", ".ist zu niedrig."))
        self.end(process)

    # No line of a header comes from a subject, no command from an address.
    def test_an_email_that_would_be_another_one(self):
        server, process, client = self.begin()
        for place, text in ((104, "a\r\nBcc: evil@plant.example"), (186, "a\r\n.\r\nMAIL FROM:<evil@plant.example>\r\n")):
            client.write(DATA_AREA, place + 1, bytes([len(text)]) + text.encode(), BYTE, 10)
        self.send(client)
        mail = email.message_from_bytes(server.mails[0], policy=email.policy.default)
        self.assertEqual((mail["Bcc"], mail["Subject"]), (None, "a  Bcc: evil@plant.example"))
        self.assertEqual(len([line for line in server.said if line.startswith("MAIL")]), 1)
        for text in ("x@y>\r\nRCPT TO:<z@y", "nobody", "", "a@b@c", "a@b;" * 11):
            client.write(DATA_AREA, 1, bytes([len(text)]) + text.encode(), BYTE, 10)
            client.write(FLAGS, 20, b"\0\0")
            self.send(client)
            self.assertEqual(client.read(FLAGS, 20, 2), b"\x81\x84", text)
        for length in (1, 61, 185):  # cut off
            client.write(FLAGS, 20, b"\0\0")
            self.send(client, length)
            self.assertEqual(client.read(FLAGS, 20, 2), b"\x81\x84", length)
        self.assertEqual(len(server.mails), 1)
        self.end(process)

    def test_a_server_that_refuses(self):
        server, process, client = self.begin(RCPT="550 nobody of this name")
        self.send(client)
        self.assertEqual((client.read(FLAGS, 10), client.read(FLAGS, 20, 2)), (b"\0", b"\x83\x02"))
        self.assertEqual(process.stderr.readline(), "merker: e-mail connection 5 of the CP: the mail server says: 550 nobody of this name\n")
        self.assertEqual(server.said[-1], "QUIT")
        del server.answers["RCPT"]
        server.answers["EHLO"] = "500 what?"  # an old one
        self.send(client)
        self.assertEqual(client.read(FLAGS, 10), b"\x01")
        self.assertIn("HELO [127.0.0.1]", server.said)
        server.answers["MAIL"] = "nonsense"
        client.write(FLAGS, 20, b"\0\0")
        self.send(client)
        self.assertEqual(client.read(FLAGS, 20, 2), b"\x83\x02")
        server.answers["MAIL"] = "x" * 100_000
        client.write(FLAGS, 20, b"\0\0")
        self.send(client)
        self.assertEqual(client.read(FLAGS, 20, 2), b"\x83\x02")
        server.close()
        client.write(FLAGS, 20, b"\0\0")
        self.send(client)
        self.assertEqual(client.read(FLAGS, 20, 2), b"\x83\x04")
        self.end(process)


class Settings(ItCase):
    def refused(self, old, new, said):
        self.write("plant/merker.toml", self.text.replace(old, new))
        call = self.merker("check", "plant")
        self.assertEqual((call.code, said in call.err + call.out), (PROBLEMS, True), call.err + call.out)

    def test_wrong_settings(self):
        self.plant()
        self.expect(GOOD, "check", "plant")
        self.text = self.read("plant/merker.toml")
        web = self.text.splitlines()[5]
        for old, new, said in (
                ("6GK7 343-1GX11-0XE0", "6GK7 343-1EX30-0XE0", "CP 343-1 Ethernet has no web server; a CP 343-1 IT has one"),
                (f"port = {self.web}, ", "", "the port of the web server like 8081"),
                ('"pages"', '"none"', "a folder of this project, in which HTML pages lie"),
                ('"pages"', '"../plant/pages"', "a folder of this project"), ('"pages"', '"/"', "a folder of this project"),
                ("smtp://127.0.0.1:9", "tcp://127.0.0.1:9", "the address of a mail server like"),
                ("presse@plant.example", "presse", "the address of the sender like"),
                ("id = 5", "id = 5\nlocal_port = 3", "local_port")):
            self.refused(old, new, said)
        self.write("plant/merker.toml", self.text.replace(web, "").replace("6GK7 343-1GX11-0XE0", "6GK7 343-1EX30-0XE0"))
        self.assertIn("the station needs a CP 343-1 IT", self.merker("check", "plant").err)

    # Without the S7 server there is no mail server: virtual time waits for nobody.
    def test_in_virtual_time(self):
        self.plant()
        call = self.expect(GOOD, "run", "plant", "--for", "1s", "--set", "MW 40 = 332, M 0.0 = 1", "--print", "MW 20, MB 10")
        self.assertEqual(call.lines, ["MW 20 = W#16#8304", "MB 10 = B#16#00"])


if __name__ == "__main__":
    unittest.main()
