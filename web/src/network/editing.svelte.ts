// The selection in the networks of a block, the operand that is being typed, and its edits: one after the other, each of what
// the one before has made.
import { tick } from 'svelte';
import { connection } from '../connection';
import type { NetworkPicture } from '../connection/protocol';
import type { OpenDocument } from '../editor/document.svelte';
import { workspace } from '../editor/workspace.svelte';
import { attempt } from '../state/messages.svelte';
import { nextPin } from './boxes';
import { elementAt } from './element_at';
import { Headings } from './headings.svelte';
import { inOrder, itemAt, itemsOf, nextMissing, NO_PIN, same, type Direction, type Item, type Place } from './items';
import { placed, type Change, type Edited } from './keys';
import type { NetworkViewProps } from './network_view';
import { Networks, type Wanted } from './networks.svelte';
import { Turn } from './turn';
import { standingAt } from './statement_at';
import { stepFrom } from './walking';

const BEGINNING = { node: -1, field: NO_PIN };

export class Editing {
  readonly networks = new Networks();
  readonly turn = new Turn();
  readonly headings = new Headings();
  chosen = $state(1);
  selected = $state.raw<Place | null>(null);
  field = $state.raw<{ item: Item; text: string } | null>(null);
  private entering = true;
  /** The keyboard goes where the program wants it. */
  private moving = false;
  /** Where somebody has gone while an edit was on its way. */
  private gone: number | undefined;

  /** `host` holds the networks; `wanted` is what is shown in it. */
  constructor(
    private readonly given: () => NetworkViewProps,
    private readonly host: () => HTMLElement,
    private readonly wanted: () => Wanted | undefined,
  ) {}

  get props(): NetworkViewProps {
    return this.given();
  }
  get picture(): NetworkPicture | undefined {
    return this.networks.list.find((one) => one.number === this.chosen);
  }
  get items(): Item[] {
    return this.picture ? itemsOf(this.picture.shapes) : [];
  }
  get current(): Item | null {
    return this.picture ? itemAt(this.picture.shapes, this.selected) : null;
  }
  /** Of what the server says. */
  get language() {
    return this.wanted()?.language ?? 'german';
  }
  /** At the heading of a ladder one stands before its first element. */
  first(): Item | undefined {
    if (this.current || this.props.view !== 'kop') return undefined;
    return inOrder(this.items).find(({ kind }) => kind === 'contact');
  }
  private get readonly(): boolean {
    return this.props.document.readonly;
  }

  /** The cursor of the text moves the selection, unless it is there already. */
  follow(): void {
    const { line } = this.props;
    const at = this.networks.at(line);
    if (!at || this.turn.busy) return;
    const here = at.number === this.chosen && itemAt(at.shapes, this.selected);
    if (here && (at.line + here.line === line || this.holds(at, here))) return;
    const [found] = line < at.first ? [] : standingAt(itemsOf(at.shapes), line - at.line);
    if (at.number === this.chosen && !found) return;
    this.chosen = at.number;
    this.selected = found ?? null;
  }

  async show(): Promise<void> {
    const wanted = this.wanted();
    if (wanted) await this.networks.show(wanted);
    const { list } = this.networks;
    if (!this.picture && list.length > 0) this.stand(Math.min(this.chosen, list.length));
  }

  /** At the heading of a network. */
  stand(number: number): void {
    if (this.chosen === number && !this.selected) return;
    this.chosen = number;
    this.selected = null;
  }

  /** The keyboard goes to the network of the cursor, as soon as it is drawn. */
  async enter(): Promise<void> {
    this.entering = true;
    await this.show();
    await this.arrived();
  }

  /** What was selected may be gone; the keyboard stays. */
  async refresh(): Promise<void> {
    const had = this.host().contains(document.activeElement);
    await this.show();
    await this.arrived();
    await tick();
    if (had && document.activeElement === document.body) await this.focus(this.chosen, this.selected);
  }

  private async arrived(): Promise<void> {
    this.follow();
    if (!this.entering || this.networks.line !== this.props.block?.line) return; // of the block before
    this.entering = false;
    if (!this.networks.at(this.props.line)) this.stand(1); // the declarations
    if (this.networks.list.length > 0) await this.focus(this.chosen, this.selected);
    else this.host().focus({ preventScroll: true });
  }

  /** Who goes to a heading stands in its network; while an edit is on its way, as soon as it is there. */
  headed(number: number): void {
    if (this.moving) return;
    if (this.turn.busy) this.gone = number;
    else this.stand(number);
  }

  /** Somebody has gone elsewhere, or to another view, while the answer was on its way: the keyboard stays there. */
  private left(): boolean {
    const host: HTMLElement | null = this.host();
    const { activeElement } = document;
    if (this.gone !== undefined) this.stand(this.gone);
    const isHere = !activeElement || activeElement === document.body || host?.contains(activeElement);
    return !host || !isHere || this.gone !== undefined;
  }

  async focus(number: number, place: Place | null): Promise<void> {
    this.chosen = number;
    this.selected = place;
    await tick();
    // Meanwhile another view may have been chosen.
    const host = this.host();
    const there = host && elementAt(host, number, place);
    this.moving = true;
    (there ?? host)?.focus({ preventScroll: true });
    this.moving = false;
    there?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  }

  select(number: number, item: Item | null): void {
    this.chosen = number;
    this.selected = item;
    const at = this.networks.list.find((one) => one.number === number);
    if (at && !(item && this.holds(at, item))) this.props.ongoto(at.line + (item?.line ?? 0));
  }

  /** The cursor of the text stays at the statement of an element that it is at, the one where the CPU stopped. */
  private holds({ line, shapes }: NetworkPicture, item: Item): boolean {
    return standingAt(itemsOf(shapes), this.props.line - line).some((one) => same(one, item));
  }

  go(number: number, item: Item | null): void {
    void this.focus(number, item).then(() => this.select(number, item));
  }

  walk(direction: Direction): void {
    const to = stepFrom(this.networks.list, this.chosen, this.current, direction);
    if (to) this.go(to.network, to.item);
  }

  toEnd(first: boolean): void {
    const to = inOrder(this.items).at(first ? 0 : -1);
    if (to) this.go(this.chosen, to);
  }

  open(item: Item, text: string): void {
    if (!this.readonly && item.operand !== undefined) this.field = { item, text };
  }

  close(): void {
    const at = this.field?.item ?? null;
    this.field = null;
    void this.focus(this.chosen, at);
  }

  /** `onwards`: to the next operand that is missing. */
  finish(text: string, onwards: boolean): void {
    if (!this.field) return;
    const { item } = this.field;
    this.field = null;
    if (text === '' || text === item.operand) {
      if (onwards) void this.turn.take(() => this.further(item));
    } else void this.edit({ action: 'setOperand', operands: [text] }, { ...item, pin: item.field }, onwards);
  }

  private async further(from: Place & { field: number }): Promise<void> {
    const list = this.items;
    const to = nextPin(list, from) ?? nextMissing(list, from);
    const stays = list.find((item) => same(item, from)) ?? list.find(({ node }) => node === from.node);
    await this.focus(this.chosen, to ?? stays ?? null);
    if (to) this.open(to, to.operand ?? '');
  }

  undo(again: boolean): void {
    void this.turn.take(async () => {
      this.host().focus({ preventScroll: true });
      this.props.onundo(again);
      await tick();
      await this.enter();
    });
  }

  /** False: it was refused. */
  async edit(change: Change, at: Place | null, onwards = false): Promise<boolean> {
    if (this.turn.busy || this.readonly || !this.props.block) return false;
    let done = false;
    await this.turn.take(async () => void (done = await this.ask(change, at, onwards)));
    return done;
  }

  async ask(change: Change, at: Place | null, onwards: boolean): Promise<boolean> {
    this.gone = undefined;
    this.host().focus({ preventScroll: true });
    const { document, block } = this.props;
    const place = at ? { node: at.node, pin: at.pin, first: at.first } : {};
    const { path, text } = document;
    const answer = await attempt(
      connection.ask('networks.edit', {
        file: path,
        text,
        line: block!.line,
        network: this.picture?.number ?? 0,
        edit: { ...placed(change, this.current), ...place },
        view: this.props.view,
        language: this.language,
      }),
    );
    const done = answer !== undefined && document.text === text;
    if (!done) await this.refused(change, at);
    else if (this.props.document !== document || this.props.block?.name !== block!.name)
      await this.changedElsewhere(document, answer);
    else await this.changedTo(answer, change, at, onwards);
    return done;
  }

  private async refused(change: Change, at: Place | null): Promise<void> {
    this.turn.forget();
    if (change.action === 'label' || change.action === 'heading') return; // its form stays open
    const isThere = (item: Item) => same(item, at) || (item.node === at?.node && item.field === at.pin);
    const typed = change.action === 'setOperand' && this.items.find(isThere);
    if (typed) return this.open(typed, change.operands?.[0] ?? '');
    this.turn.deaf = true;
    await this.focus(this.chosen, at);
  }

  /** Another block has been opened meanwhile: the keyboard belongs there. */
  private async changedElsewhere(document: OpenDocument, { from, to, lines }: Edited): Promise<void> {
    const all = document.text.split('\n');
    all.splice(from - 1, to - from, ...lines);
    workspace.edit(document, all.join('\n'));
    await tick();
    await this.enter();
  }

  private async changedTo(answer: Edited, change: Change, at: Place | null, onwards: boolean): Promise<void> {
    this.props.onedit(answer.from, answer.to, answer.lines);
    await tick();
    await this.show();
    this.chosen = answer.network;
    const list = this.items;
    const to = list.find((item) => same(item, answer)) ?? list.find((item) => item.node === answer.node);
    this.selected = to ?? null;
    if (this.left()) return;
    if (onwards) await this.further({ ...answer, field: at?.pin ?? NO_PIN });
    else {
      await this.focus(this.chosen, to ?? null);
      const made = list.filter(({ node }) => node === answer.node);
      const gap = nextPin(list, { ...BEGINNING, node: answer.node }) ?? nextMissing(made, BEGINNING);
      if (gap && change.action === 'insert') this.open(gap, gap.operand ?? '');
    }
    if (this.picture) this.props.ongoto(this.picture.line + (to?.line ?? 0));
  }

  /** To the label of the chosen network; a block without one gets it. */
  async label(): Promise<void> {
    if (this.picture || (await this.edit({ action: 'newNetwork' }, null))) this.headings.show(this.chosen, 'label');
  }

  /** Title, comment, label of a network. */
  async changeAll(number: number, changes: Change[]): Promise<void> {
    for (const change of changes) {
      this.chosen = number;
      if (await this.edit(change, null)) continue;
      return this.headings.show(number, change.action === 'label' ? 'label' : 'title');
    }
    this.headings.close(number);
    if (changes.length === 0) await this.focus(number, null);
  }

  /** Enter, or a letter: the operand of the selection, otherwise the first one that is missing. False: there is none. */
  type(text?: string): boolean {
    const item = this.current;
    const at = item?.operand === undefined ? nextMissing(this.items, item ?? BEGINNING) : item;
    if (at) this.open(at, text ?? at.operand ?? '');
    return at !== undefined;
  }
}
