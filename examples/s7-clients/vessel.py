"""Watches the vessel of chapter 4.2 over S7 communication with nothing but Python and libmerker-s7.

    merker run examples/vessel-emptying --s7 10102
    python3 vessel.py 127.0.0.1 10102
"""
import ctypes
import sys
import time

INPUTS = ("Start", "Stop", "Level min", "Level max")  # E 0.0 to E 0.3
OUTPUTS = ("Outlet valve", "Inlet valve", "Lamp emptying")  # A 1.0 to A 1.2
REMOTE_PORT = 2


class Plc:
    def __init__(self, address, port, library="libmerker-s7.so.0"):
        self.library = ctypes.CDLL(library)
        self.library.Cli_Create.restype = ctypes.c_size_t
        self.client = ctypes.c_size_t(self.library.Cli_Create())
        self.do("Cli_SetParam", REMOTE_PORT, ctypes.byref(ctypes.c_uint16(port)))
        self.do("Cli_ConnectTo", address.encode(), 0, 2)

    def do(self, function, *arguments):
        error = getattr(self.library, function)(self.client, *arguments)
        if error != 0:
            text = ctypes.create_string_buffer(120)
            self.library.Cli_ErrorText(error, text, len(text))
            raise OSError(f"{function}: {text.value.decode()}")

    def byte(self, function, number):
        value = ctypes.c_uint8()
        self.do(function, number, 1, ctypes.byref(value))
        return value.value


def main():
    address = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
    plc = Plc(address, int(sys.argv[2]) if len(sys.argv) > 2 else 102)
    last = [0, 0]
    while True:
        now = [plc.byte("Cli_EBRead", 0), plc.byte("Cli_ABRead", 1)]
        for names, value, before in zip((INPUTS, OUTPUTS), now, last):
            for bit, name in enumerate(names):
                if (value ^ before) >> bit & 1:
                    print(f"{name:<14} {value >> bit & 1}", flush=True)
        last = now
        time.sleep(0.1)


if __name__ == "__main__":
    main()
