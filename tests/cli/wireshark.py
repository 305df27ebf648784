"""What tshark says of a conversation: written as a capture of the TCP port that S7 communication has."""
import shutil
import struct
import subprocess

# Wireshark's severities: error, and what it calls malformed.
BAD = "_ws.malformed || _ws.expert.severity >= 0x00800000"


class Capture:
    def __init__(self, path):
        self.path, self.sent = path, [1, 1]  # sequence numbers of both sides
        self.file = open(path, "wb")
        self.file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101))  # raw IP
        self.frames = 0

    def add(self, answer, data):
        """A segment of the client, or of the server."""
        ports = (102, 40000) if answer else (40000, 102)
        side = int(answer)
        tcp = struct.pack(">HHIIBBHHH", *ports, self.sent[side], self.sent[1 - side], 0x50, 0x18, 65535, 0, 0)
        self.sent[side] += len(data)
        here = b"\x7F\x00\x00\x01"
        packet = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 40 + len(data), 0, 0, 64, 6, 0, here, here) + tcp + data
        self.frames += 1
        self.file.write(struct.pack("<IIII", self.frames, 0, len(packet), len(packet)) + packet)

    def ask(self, expression, *fields):
        """A line for each frame of which the expression is true."""
        self.file.flush()
        tshark = shutil.which("tshark")
        if tshark is None:
            raise RuntimeError("tshark is missing (Debian package tshark)")
        command = [tshark, "-n", "-r", str(self.path), "-Y", expression]
        command += ["-T", "fields"] if fields else []
        for field in fields:
            command += ["-e", field]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()

    def close(self):
        self.file.close()


class Recorded:
    """A socket of which a capture sees everything that is sent and heard."""
    def __init__(self, socket, capture):
        self.socket, self.capture, self.heard = socket, capture, b""

    def sendall(self, data):
        self.flush()
        self.capture.add(False, data)
        self.socket.sendall(data)

    def recv(self, count):
        data = self.socket.recv(count)
        self.heard += data
        return data

    def flush(self):
        if self.heard:
            self.capture.add(True, self.heard)
        self.heard = b""

    def close(self):
        self.flush()
        self.socket.close()
