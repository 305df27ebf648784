#!/usr/bin/env python3
"""usage: doctored_test.py MERKER

Makes a memory card, and of it cards that somebody has doctored or that are damaged. What must hold for each: `merker run
--card` says P1003 (or another problem that is named here), ends with exit code 4 within seconds and little memory, and
leaves every file in the folder byte for byte as it was.
"""
import os
import pathlib
import random
import resource
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import zlib

MERKER = sys.argv[1]
PROGRAM = pathlib.Path(__file__).parent / "kept.awl"
SECONDS = 10  # of processor time; a card is read in milliseconds
MEMORY = 2 << 30

ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i"
COLUMNS = {"block": "kind, number, read_only, container, checksum", "setting": "name, value, checksum",
           "area": "kind, number, length", "page": "kind, number, page, bytes, checksum"}


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    if "ASAN_OPTIONS" not in os.environ:  # sanitizers reserve terabytes of addresses; they limit what is used themselves
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def run(folder, *more):
    return subprocess.run([MERKER, "run", "--card", str(folder), "--for", "10ms", *more], capture_output=True,
                          timeout=10 * SECONDS, preexec_fn=limits, text=True, errors="replace")


def snapshot(folder):
    files = {}
    for path in sorted(folder.iterdir()):
        kind = "link" if path.is_symlink() else "file" if path.is_file() else "other"
        files[path.name] = (kind, path.read_bytes() if kind == "file" else None)
    return files


def sql(*statements, writable_schema=False):
    """Changes the card by SQL, as its user would who has sqlite3."""
    def change(folder):
        base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
        base.create_collation("mine", lambda a, b: 0)
        if writable_schema:
            base.execute("PRAGMA writable_schema = ON")
        for statement in statements:
            base.execute(statement)
        base.close()
    return change


def view(table, select):
    return sql(f"DROP TABLE {table}", f"CREATE VIEW {table}({COLUMNS[table]}) AS {select}")


def table(name, columns):
    return sql(f"DROP TABLE {name}", f"CREATE TABLE {name}({columns}")


def schema(table, old, new):
    return sql(f"UPDATE sqlite_schema SET sql = replace(sql, '{old}', '{new}') WHERE name = '{table}'",
               writable_schema=True)


def content(bytes_of):
    def change(folder):
        file = folder / "card.sqlite"
        file.write_bytes(bytes_of(file.read_bytes()))
    return change


def patched(offset, new):
    return content(lambda old: old[:offset] + new + old[offset + len(new):])


def instead(make, part=""):
    """Puts something else in the place of one of the files."""
    def change(folder):
        file = folder / ("card.sqlite" + part)
        if file.exists():
            file.rename(folder / "moved")
        make(file)
    return change


def many_tables(folder):
    base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
    base.execute("BEGIN")
    for number in range(6000):
        base.execute(f"CREATE TABLE t{number}(a)")
    base.execute("COMMIT")
    base.close()


def in_the_log(*statements):
    """What was done last stands in the log only."""
    def change(folder):
        base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
        base.execute("PRAGMA wal_autocheckpoint = 0")
        for statement in statements:
            base.execute(statement)
        with tempfile.TemporaryDirectory() as kept:
            for part in ("", "-wal"):
                shutil.copy(folder / ("card.sqlite" + part), kept)
            base.close()
            for part in ("", "-wal"):
                shutil.copy(pathlib.Path(kept) / ("card.sqlite" + part), folder)
    return change


def with_journal(*statements):
    """A change that was cut off: SQLite brings the state before it back when it opens the card."""
    def change(folder):
        base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
        base.execute("PRAGMA journal_mode = DELETE")
        for statement in statements:
            base.execute(statement)
        base.execute("PRAGMA cache_size = 1")
        base.execute("BEGIN")
        base.execute("UPDATE page SET checksum = checksum + 1")
        with tempfile.TemporaryDirectory() as kept:
            for part in ("", "-journal"):
                shutil.copy(folder / ("card.sqlite" + part), kept)
            base.close()
            for part in ("", "-journal"):
                shutil.copy(pathlib.Path(kept) / ("card.sqlite" + part), folder)
    return change


def seal(base):
    """The sum of settings, blocks and areas (docs/formats/card.md), so that deeper checks have something to do."""
    def text(value):
        return len(value).to_bytes(4, "big") + value.encode()
    def number(value):
        return (value & 0xFFFFFFFF).to_bytes(4, "big")
    settings = base.execute("SELECT name, checksum FROM setting WHERE name <> 'contents' ORDER BY name")
    loaded = b"".join(text(name) + number(checksum) for name, checksum in settings)
    for row in base.execute("SELECT kind, number, read_only, checksum FROM block ORDER BY kind, number"):
        loaded += b"".join(map(number, row))
    areas = base.execute("SELECT kind, number, length FROM area ORDER BY kind, number")
    kept = b"".join(text(kind) + number(at) + number(length) for kind, at, length in areas)
    value = number(zlib.crc32(loaded)) + number(zlib.crc32(kept))
    base.execute("UPDATE setting SET value = ?, checksum = ? WHERE name = 'contents'", (value, zlib.crc32(value)))


def sealed(*statements):
    def change(folder):
        base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
        for statement in statements:
            base.execute(statement)
        seal(base)
        base.close()
    return change


def old(*statements):
    """A card of format 1, which has no such sum."""
    return sql(*statements, "DELETE FROM setting WHERE name = 'contents'", "PRAGMA user_version = 1")


def setting(value, name="configuration"):
    checksum = zlib.crc32(value)
    def change(folder):
        base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
        base.execute("INSERT OR REPLACE INTO setting VALUES (?, ?, ?)", (name, value, checksum))
        seal(base)
        base.close()
    return change


def no_area(kind):
    return f"DELETE FROM area WHERE kind = '{kind}'", f"DELETE FROM page WHERE kind = '{kind}'"


def shorter(folder):
    """The DB lacks its last two bytes; all checksums of bytes are right."""
    base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
    last, data = base.execute("SELECT page, bytes FROM page WHERE kind = 'DB' AND number = 1 ORDER BY page DESC").fetchone()
    data = data[:-2]
    base.execute("UPDATE page SET bytes = ?, checksum = ? WHERE kind = 'DB' AND number = 1 AND page = ?",
                 (data, zlib.crc32(data), last))
    base.execute("UPDATE area SET length = length - 2 WHERE kind = 'DB' AND number = 1")
    base.close()


def both(*changes):
    def change(folder):
        for one in changes:
            one(folder)
    return change


def area(kind, make):
    """Other bytes in an area, with the right checksums."""
    def change(folder):
        base = sqlite3.connect(folder / "card.sqlite", isolation_level=None)
        rows = base.execute("SELECT number, page, bytes FROM page WHERE kind = ? ORDER BY page", (kind,)).fetchall()
        new = make(b"".join(row[2] for row in rows))
        base.execute("DELETE FROM page WHERE kind = ?", (kind,))
        base.execute("UPDATE area SET length = ? WHERE kind = ?", (len(new), kind))
        for page in range(0, len(new), 256):
            part = new[page:page + 256]
            base.execute("INSERT INTO page VALUES (?, 0, ?, ?, ?)", (kind, page // 256, part, zlib.crc32(part)))
        seal(base)
        base.close()
    return change


KINDS = {
    "block is an endless view": view("block", ENDLESS + ", 1, 0, x'', 0 FROM n"),
    "page is an endless view": view("page", ENDLESS + ", 1, 0, x'', 0 FROM n"),
    "area is an endless view": view("area", ENDLESS + ", 1, 0 FROM n"),
    "setting is a view of 900 MB": view("setting", "SELECT 'cpu', zeroblob(900000000), 0"),
    "setting is an endless view": view("setting", ENDLESS + ", x'', 0 FROM n"),
    "another view": sql(f"CREATE VIEW extra AS {ENDLESS} FROM n"),
    "an endless trigger": sql(f"CREATE TRIGGER extra AFTER INSERT ON page BEGIN INSERT INTO area {ENDLESS}, i, i FROM n;"
                              " END"),
    "a trigger that drops what is saved": sql("CREATE TRIGGER extra BEFORE INSERT ON page BEGIN SELECT RAISE(IGNORE);"
                                              " END"),
    "a trigger that fails": sql("CREATE TRIGGER extra BEFORE INSERT ON page BEGIN SELECT RAISE(ABORT, 'no'); END"),
    "another table": sql("CREATE TABLE extra(a)"),
    "20,000 tables": many_tables,
    "a table less": sql("DROP TABLE page"),
    "a virtual table": sql("CREATE VIRTUAL TABLE extra USING fts4(a)"),
    "statistics": sql("ANALYZE"),
    "another index": sql("CREATE INDEX extra ON page(bytes)"),
    "a partial index": sql("CREATE INDEX extra ON page(page) WHERE page > 5"),
    "an index on an expression": sql("CREATE INDEX extra ON page(hex(bytes))"),
    "a unique index": sql("CREATE UNIQUE INDEX extra ON page(kind, number, page, checksum)"),
    "a column more": sql("ALTER TABLE area ADD COLUMN extra INTEGER"),
    "a column less": sql("ALTER TABLE area DROP COLUMN length"),
    "a column of another name": sql("ALTER TABLE area RENAME COLUMN length TO size"),
    "a generated column": sql("ALTER TABLE area ADD COLUMN extra AS (hex(zeroblob(100000000)))"),
    "an expensive check": table("area", "kind TEXT, number INTEGER, length INTEGER"
                                        " CHECK(length(hex(zeroblob(100000000))) > 0), PRIMARY KEY(kind, number))"),
    "an expensive default": table("area", "kind TEXT, number INTEGER DEFAULT (length(zeroblob(100000000))),"
                                          " length INTEGER, PRIMARY KEY(kind, number))"),
    "a collation": table("setting", "name TEXT COLLATE NOCASE PRIMARY KEY, value BLOB, checksum INTEGER)"),
    "an unknown collation": table("setting", "name TEXT COLLATE mine PRIMARY KEY, value BLOB, checksum INTEGER)"),
    "a strict table": table("setting", "name TEXT PRIMARY KEY, value BLOB, checksum INTEGER) STRICT"),
    "other types": table("setting", "name BLOB PRIMARY KEY, value TEXT, checksum REAL)"),
    "no primary key": table("setting", "name TEXT, value BLOB, checksum INTEGER)"),
    "another name in the schema": schema("area", "area", "AREA"),
    "a schema of a megabyte": schema("area", "length", "length" + " " * 1000000),
    "one table for two": sql("UPDATE sqlite_schema SET rootpage = (SELECT rootpage FROM sqlite_schema WHERE name ="
                             " 'area') WHERE name = 'setting'", writable_schema=True),
    "a table that is the index of another": sql("UPDATE sqlite_schema SET rootpage = (SELECT rootpage FROM"
                                                " sqlite_schema WHERE name = 'sqlite_autoindex_area_1') WHERE name ="
                                                " 'setting'", writable_schema=True),
    "a root page far outside": sql("UPDATE sqlite_schema SET rootpage = 1000000 WHERE name = 'page'",
                                   writable_schema=True),
    "format 0": sql("PRAGMA user_version = 0"),
    "format -1": sql("PRAGMA user_version = -1"),
    "a view in the log": in_the_log("DROP TABLE block", f"CREATE VIEW block({COLUMNS['block']}) AS {ENDLESS}, 1, 0,"
                                                        " x'', 0 FROM n"),
    "only a log": lambda folder: (in_the_log("PRAGMA user_version = 1", "DELETE FROM page")(folder),
                                  (folder / "card.sqlite").write_bytes(b"")),
    "a view behind a journal": with_journal("CREATE VIEW extra AS SELECT 1"),
    "a pipe": instead(os.mkfifo),
    "a folder": instead(os.mkdir),
    "a link": instead(lambda file: os.symlink("moved", file)),
    "a link to a device": instead(lambda file: os.symlink("/dev/zero", file)),
    "a link to nothing": instead(lambda file: os.symlink("nothing", file)),
    "a pipe as the log": instead(os.mkfifo, "-wal"),
    "a pipe as the journal": instead(os.mkfifo, "-journal"),
    "a device as the log": instead(lambda file: os.symlink("/dev/zero", file), "-wal"),
    "100 MB of nothing behind it": content(lambda old: old + bytes(100 << 20)),
    "10 MB of nothing behind it": content(lambda old: old + bytes(10 << 20)),
    "a huge number of pages": patched(28, b"\x7f\xff\xff\xff"),
    "a free list of garbage": patched(32, b"\0\0\0\2\0\0\0\7"),
    "half of it": content(lambda old: old[:len(old) // 2 // 1024 * 1024]),
    "half a page": content(lambda old: old[:1536]),
    "a row of 5 MB": sql("UPDATE setting SET value = zeroblob(5000000)"),
    "a million settings": sql(f"INSERT INTO setting {ENDLESS}, x'', 0 FROM n LIMIT 300000"),
    "texts for numbers": sql("UPDATE block SET number = 'one' WHERE rowid = 1"),
    "numbers for bytes": sql("UPDATE block SET container = 7"),
    "nothing for bytes": sql("UPDATE page SET bytes = NULL"),
    "a kind of block that does not exist": sql("UPDATE block SET kind = kind + 256"),
    "a number of a block that does not exist": sql("UPDATE block SET number = number + 65536"),
    "pages of no area": sql("INSERT INTO page VALUES ('DB', 77, -1, x'00', 3523407757)"),
    "a length below zero": sql("UPDATE area SET length = -1"),
    "a length of terabytes": sql("UPDATE area SET length = 1000000000000"),
    "another setting": sql("INSERT INTO setting VALUES ('extra', x'', 0)"),
    "an area of another kind": sql("UPDATE area SET kind = 'E' WHERE kind = 'M'", "UPDATE page SET kind = 'E' WHERE"
                                                                                  " kind = 'M'"),
    "too many counters": area("Z", lambda old: old * 9000),
    "times outside": area("state", lambda old: b"\x7f" + b"\xff" * 15 + b"\1"),
    "an event of no block": area("diagnostics", lambda old: b"\x43\x02" + bytes(8) + bytes(2) + b"\1\xff\xff\xff"
                                 + bytes(4 + 10 + 8)),
}
STATE = ("state", "M", "T", "Z", "meters", "diagnostics")
# Each row that is left is right. Refused for a program from elsewhere, too: it would take the card as one of another CPU.
MISSING = {
    "no settings": sql("DELETE FROM setting"),
    "no CPU": sql("DELETE FROM setting WHERE name = 'cpu'"),
    "no CPU, sealed": sealed("DELETE FROM setting WHERE name = 'cpu'"),
    "an empty CPU": sql("UPDATE setting SET value = x'', checksum = 0 WHERE name = 'cpu'"),
    "an unknown CPU": setting(b"evil", "cpu"),
    "a CPU that clears the screen": setting(b"\x1b[2Jevil", "cpu"),
    "no sum": sql("DELETE FROM setting WHERE name = 'contents'"),
    "no OB 1": sql("DELETE FROM block WHERE kind = 8"),
    "no blocks": sql("DELETE FROM block"),
    "no areas": sql("DELETE FROM area", "DELETE FROM page"),
    **{f"no {kind}": sql(*no_area(kind)) for kind in (*STATE, "DB")},
    **{f"no {kind}, sealed": sealed(*no_area(kind)) for kind in STATE},
    "a DB that is too short": shorter,
    "format 1, no settings": old("DELETE FROM setting"),
    "format 1, an unknown CPU": both(setting(b"evil", "cpu"), old()),
    **{f"format 1, no {kind}": old(*no_area(kind)) for kind in (*STATE, "DB")},
    "format 1, a DB that is too short": both(shorter, old()),
    "format 1 with a sum": sql("PRAGMA user_version = 1"),
}
OTHERS = {  # refused as something else
    "an empty file": (content(lambda old: b""), "P1007"),
    "never loaded": (sql("DELETE FROM setting", "DELETE FROM block", "DELETE FROM area", "DELETE FROM page"), "P1007"),
    "a newer format": (sql("PRAGMA user_version = 3"), "P1005"),
    "another program's": (sql("PRAGMA application_id = 1"), "P1002"),
    "no database": (content(lambda old: b"text " * 100), "P1002"),
}


class Cards:
    def __init__(self, folder):
        self.folder, self.failures, self.good = folder, 0, folder / "good"
        made = subprocess.run([MERKER, "run", str(PROGRAM), "--card", str(self.good), "--for", "50ms"],
                              capture_output=True, text=True, check=False)
        assert made.returncode == 0, made.stderr

    def copy(self):
        copy = self.folder / "copy"
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(self.good, copy)
        return copy

    def fail(self, name, text):
        self.failures += 1
        print(f"FAILED {name}: {text}")

    def refused(self, name, change, problem, *more):
        card = self.copy()
        change(card)
        before = snapshot(card)
        try:
            result = run(card, *more)
        except subprocess.TimeoutExpired:
            return self.fail(name, "does not end")
        if result.returncode != 4 or f"[{problem}]" not in result.stderr:
            self.fail(name, f"exit {result.returncode}: {result.stderr[:300]}")
        if "\x1b" in result.stderr:
            self.fail(name, "control characters in the message")
        if snapshot(card) != before:
            self.fail(name, "the card was changed")

    def taken(self, name, change):
        """A good card, and after the run as well."""
        card = self.copy()
        change(card)
        for _ in range(2):
            result = run(card)
            if result.returncode != 0:
                self.fail(name, f"exit {result.returncode}: {result.stderr[:300]}")

    def anything(self, name, change):
        """It may be read, but a card that is refused stays as it was."""
        card = self.copy()
        change(card)
        before = snapshot(card)
        result = run(card)
        if result.returncode not in (0, 1, 3, 4):
            self.fail(name, f"exit {result.returncode}: {result.stderr[:300]}")
        if result.returncode == 4 and snapshot(card) != before:
            self.fail(name, "the card was changed")


def damaged(random_, old):
    new = bytearray(old)
    for _ in range(random_.randint(1, 6)):
        new[random_.randrange(len(new))] ^= 1 << random_.randrange(8)
    return bytes(new)


def mutated(random_, old):
    new = bytearray(old)
    for _ in range(random_.randint(1, 4) if new else 0):
        at = random_.randrange(len(new))
        new[at:at + 8] = random_.choice([b"\0" * 8, b"\xff" * 8, b"\x7f\xff\xff\xff\xff\xff\xff\xff",
                                         random_.randbytes(8)])[:len(new) - at]
    return bytes(new)


def main():
    with tempfile.TemporaryDirectory() as name:
        cards = Cards(pathlib.Path(name))
        for kind, change in KINDS.items():
            cards.refused(kind, change, "P1003")
        for kind, change in MISSING.items():
            cards.refused(kind, change, "P1003")
            cards.refused(kind + ", PATH", change, "P1003", str(PROGRAM))
        cards.taken("format 1", old())
        cards.taken("format 1, never run", old("DELETE FROM area", "DELETE FROM page"))
        cards.taken("sealed", sealed())
        for kind, (change, problem) in OTHERS.items():
            cards.refused(kind, change, problem)
        cards.anything("garbage as the log", lambda folder: (folder / "card.sqlite-wal").write_bytes(b"garbage" * 1000))
        cards.anything("a journal", with_journal())
        for seed in range(60):
            random_ = random.Random(seed)
            cards.anything(f"bits {seed}", content(lambda old: damaged(random_, old)))
            for kind in ("state", "T", "Z", "meters", "diagnostics"):
                cards.anything(f"{kind} {seed}", area(kind, lambda old: mutated(random_, old)))
        assert run(cards.copy()).returncode == 0
        print(f"{len(KINDS) + len(MISSING) + len(OTHERS)} doctored cards, {cards.failures} failures")
        return 1 if cards.failures else 0


sys.exit(main())
