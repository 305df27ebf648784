import json
import unittest

from served import Served

LINES = 200_000


class BigSource(Served):
    """The PLC goes on while a source of 200,000 lines is compiled."""

    def prepare(self):
        super().prepare()
        blocks, lines = [], LINES // 10_000
        for number in range(lines):
            body = "\n".join("      U     E 0.0;" for _ in range(9_995))
            blocks.append(f"FUNCTION FC {number + 1} : VOID\nBEGIN\nNETWORK\n{body}\n      =     M 1.0;\nEND_FUNCTION\n")
        self.big = "".join(blocks)

    def test_cycles_are_counted_meanwhile(self):
        browser = self.browser()
        browser.until(lambda b: b.state.get("mode") == "RUN" and b.state["cycles"] > 3)
        before = browser.state["cycles"]
        browser.last += 1
        files = [{"path": "main.awl", "text": (self.project / "main.awl").read_text() + self.big}]
        browser.send(json.dumps({"id": browser.last, "do": "program.check", "files": files}))
        seen = set()
        while True:
            message = json.loads(browser.receive())
            if message.get("id") == browser.last:
                break
            seen.add(message.get("cycles", before))
        self.assertIn("result", message)
        # Without a thread of its own there would be one frame at most in between; how many there are is up to the machine.
        self.assertGreater(len(seen - {before}), 1)
        self.assertGreater(max(seen), before + 10)

    def test_another_browser_is_served_meanwhile(self):
        one, two = self.browser(), self.browser()
        two.until(lambda b: b.state.get("mode") == "RUN")
        files = [{"path": "main.awl", "text": (self.project / "main.awl").read_text() + self.big}]
        one.last += 1
        one.send(json.dumps({"id": one.last, "do": "program.check", "files": files}))
        two.call("variables.write", items=[{"operand": "E 0.0", "value": "1"}])
        two.call("watch.set", list=1, items=[{"operand": "A 0.0"}])
        two.until_values([[0, "1", 1]])


if __name__ == "__main__":
    unittest.main()
