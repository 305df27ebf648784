"""Beyond this machine: certificate, key and token."""
import os
import ssl
import subprocess
import unittest
import urllib.error
import urllib.request

from served import Served
from web_socket import Browser, Refused


class Tls(Served):
    def prepare(self):
        super().prepare()
        self.certificate, key = self.folder / "c.pem", self.folder / "k.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", str(key), "-out",
                        str(self.certificate), "-days", "2", "-subj", "/CN=127.0.0.1", "-addext", "subjectAltName=IP:127.0.0.1"],
                       check=True, capture_output=True, timeout=60)
        self.arguments = ("--listen", "0.0.0.0", "--token", "secret-0123456789", "--certificate", str(self.certificate), "--key", str(key))
        self.context = ssl.create_default_context(cafile=str(self.certificate))

    def test_the_page_comes_by_tls_only(self):
        with urllib.request.urlopen(f"https://127.0.0.1:{self.port}/", context=self.context) as page:
            self.assertEqual(page.status, 200)
            self.assertIn("wss://127.0.0.1", page.headers["Content-Security-Policy"])
        with self.assertRaises((urllib.error.URLError, ConnectionError, OSError)):
            urllib.request.urlopen(f"http://127.0.0.1:{self.port}/", timeout=60)

    def test_the_socket_wants_the_token(self):
        for path in ("/ws", "/ws?token=", "/ws?token=Secret-0123456789", "/ws?token=secret-01234567890"):
            with self.assertRaises(Refused) as refused:
                Browser(self.port, path=path, context=self.context)
            self.assertEqual(refused.exception.status, 401)
        browser = self.browser(path="/ws?token=secret-0123456789", context=self.context)
        browser.until(lambda b: b.state.get("mode") == "RUN")

    def test_files_that_are_no_certificate_are_told(self):
        call = subprocess.run([os.environ["MERKER"], "run", "plant", "--port", "0", "--certificate", "plant/main.awl", "--key",
                               "plant/main.awl"], cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(call.returncode, 4)
        self.assertIn("plant/main.awl cannot be used", call.stderr)


if __name__ == "__main__":
    unittest.main()
