"""usage: pinger.py PORT

A browser that asks `ping` again and again until its input ends; the last line says how many seconds the slowest answer took. A
process of its own: whoever attacks beside it does not disturb it."""
import select
import sys
import time

from web_socket import Browser

BETWEEN = 0.01


def main():
    browser = Browser(int(sys.argv[1]))
    browser.call("ping")
    print("ready", flush=True)
    slowest = 0.0
    while not select.select([sys.stdin], [], [], BETWEEN)[0]:
        begin = time.monotonic()
        browser.call("ping")
        slowest = max(slowest, time.monotonic() - begin)
        browser.events.clear()
    print(slowest, flush=True)


if __name__ == "__main__":
    main()
