"""A table with a row for each network: its statements, its ladder, its function blocks, as one SVG."""
import dataclasses
import re
import textwrap
from html import escape

COLUMN, ROW, MARGIN, GAP = 9, 20, 14, 24  # pixels: a character, a line, around everything, between columns

# Read well in light and dark: the page's own colours, as the reader has asked for.
STYLE = (
    "svg{color:#1f2328}.page{fill:#fff}.rule{stroke:#d1d9e0}.said{fill:#59636e}"
    "@media(prefers-color-scheme:dark){svg{color:#e6edf3}.page{fill:#0d1117}.rule{stroke:#3d444d}.said{fill:#9198a1}}"
    "text{font:14px 'DejaVu Sans Mono',Consolas,monospace;fill:currentColor;white-space:pre}.title{font-weight:bold}"
    ".said{font-style:italic}path,circle{stroke:currentColor;stroke-width:1.5;fill:none}.rail{stroke-width:3}"
)


@dataclasses.dataclass
class Network:
    block: str
    number: int
    awl: list
    kop: dict  # view, lines, reason, shapes, top: as tools/networks read them
    fup: dict
    alone: bool = False  # the only network of its block

    def title(self):
        """Without the numbers of requirements."""
        name = self.block if self.alone else f"{self.block}, network {self.number}"
        return f"{name}: " + re.sub(r" *\(S[57]-[^()]*\)", "", self.kop["title"])


def text(x, y, said, kind=""):
    return (f'<text x="{x}" y="{y * ROW + 15:g}" textLength="{len(said) * COLUMN}"' + (f' class="{kind}"' if kind else "")
            + f">{escape(said, quote=False)}</text>")


def lines(x, y, said, kind=""):
    return [text(x, y + i, line, kind) for i, line in enumerate(said) if line]


def attributes(tag):
    return dict(re.findall(r'(\w+)="([^"]*)"', tag))


def lifted(tag, top):
    """As if the network were the first one of its program: what stands before it changes nothing."""
    def y(found):
        return f"{found[1]}{float(found[2]) - top:g}"

    tag = re.sub(r'(\b(?:y[12]?|cy)=")([\d.]+)', y, tag)
    return re.sub(r' d="[^"]*"', lambda path: re.sub(r"([\d.]+ )([\d.]+)", y, path[0]), tag)


def shape(tag):
    """A line or frame as a part of one path; (kind, text)."""
    a = attributes(tag)
    if tag.startswith("<line"):
        return a.get("class", ""), f"M{a['x1']} {a['y1']}L{a['x2']} {a['y2']}"
    if tag.startswith("<rect"):
        return "", f"M{a['x']} {a['y']}h{a['width']}v{a['height']}h-{a['width']}z"
    return "", a["d"]


def picture(x, y, view):
    """The shapes of a network, moved to where they stand in the table."""
    paths, out = {}, []
    for tag in (lifted(line, view["top"]) for line in view["shapes"].splitlines()):
        if re.match("<(line|rect|path)", tag):
            kind, d = shape(tag)
            paths[kind] = paths.get(kind, "") + d
        elif tag.startswith("<text"):
            out.append(re.sub(r' font-size="\d+"| lengthAdjust="\w+"', "", tag))
        elif tag.startswith("<circle"):
            a = attributes(tag)
            out.append(f'<circle cx="{a["cx"]}" cy="{a["cy"]}" r="{a["r"]}"/>')
    drawn = [f'<path class="{kind}" d="{d}"/>' if kind else f'<path d="{d}"/>' for kind, d in paths.items()]
    return [f'<g transform="translate({x - 12} {y * ROW:g})">', *drawn, *out, "</g>"]


def width(views, wanted):
    return max([len(line) for view in views if view["view"] == wanted for line in view["lines"]] + [24])


class Table:
    def __init__(self, networks):
        self.networks = networks
        self.kop = MARGIN + max(len(line) for network in networks for line in stripped(network.awl)) * COLUMN + GAP
        kop = width([network.kop for network in networks], "KOP")
        fup = width([network.fup for network in networks], "FUP")
        self.fup = self.kop + kop * COLUMN + GAP
        self.right = self.fup + fup * COLUMN + MARGIN
        self.kop_columns, self.said_columns = kop, (self.right - MARGIN - self.kop) // COLUMN

    def row(self, y, network):
        """(height, elements) of a network below its title."""
        awl = stripped(network.awl)
        out = lines(MARGIN, y, awl)
        heights = [len(awl)]
        if network.kop["view"] == "AWL":
            said = textwrap.wrap("AWL only: " + network.kop["reason"], self.said_columns)
            return max(len(awl), len(said)), out + lines(self.kop, y, said, "said")
        for x, view, wanted in ((self.kop, network.kop, "KOP"), (self.fup, network.fup, "FUP")):
            if view["view"] != wanted:
                out += lines(x, y, textwrap.wrap(f"{wanted} cannot show it", self.kop_columns), "said")
            else:
                out += picture(x, y, view)
                heights.append(len(view["lines"]))
        return max(heights), out

    def rows(self):
        y, out = 0.5, []
        out += [text(x, y, name, "title") for x, name in ((MARGIN, "AWL"), (self.kop, "KOP"), (self.fup, "FUP"))]
        y += 1.5
        for network in self.networks:
            out.append(f'<path class="rule" d="M{MARGIN} {y * ROW:g}H{self.right - MARGIN}"/>')
            title = textwrap.wrap(network.title(), (self.right - 2 * MARGIN) // COLUMN)
            out += lines(MARGIN, y + 0.5, title, "title")
            y += len(title) + 1
            height, elements = self.row(y, network)
            out += elements
            y += height + 1
        return int(y * ROW), out


def stripped(awl):
    """Without the blanks that all lines begin with."""
    return textwrap.dedent("\n".join(awl)).splitlines()


def drawn(networks):
    table = Table(networks)
    height, elements = table.rows()
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {table.right} {height}" width="{table.right}" height="{height}" role="img">\n'
            f"<title>AWL, KOP and FUP side by side</title>\n<style>{STYLE}</style>\n"
            '<rect class="page" width="100%" height="100%"/>\n' + "\n".join(elements) + "\n</svg>\n")
