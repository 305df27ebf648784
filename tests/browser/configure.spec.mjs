// The station is configured: modules by mouse and keyboard, addresses, parameters, saved and loaded (S7-HWCFG-01 to S7-HWCFG-03,
// S7-HWCFG-07 to S7-HWCFG-09). The project is one that is filled by hand (S7-MGR-02).
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { bit, expect, message, open, picture, serve, turn, until, visit } from './harness.mjs';

const server = await serve('06-first-program');
const page = await open(server, 'projects');
const slot = (number, rack = 0) => page.getByRole('table', { name: `Baugruppenträger ${rack}` }).locator(`tr[data-slot="${number}"]`);
const inSlot = (number, rack) => slot(number, rack).getByRole('button').innerText();
const catalogue = (name) => page.getByRole('region', { name: 'Katalog' }).getByRole('button', { name });
const says = (words) => message(page, words);
const shows = (number, words) => until(async () => words.test(await slot(number).innerText()), `slot ${number} with ${words}`);
const settings = () => readFileSync(join(server.workspace, 'merker', 'By hand', 'merker.toml'), 'utf-8');

test('a project without hardware (S7-MGR-02)', async () => {
  await page.getByRole('button', { name: 'Neues Projekt …' }).click();
  await page.getByLabel('Projektname').fill('By hand');
  await page.getByRole('button', { name: 'Anlegen' }).click();
  await page.locator('.path', { hasText: 'main.awl' }).first().waitFor();
  await visit(page, server, 'projects');
  await page.getByRole('button', { name: 'In die CPU laden' }).click();
  await page.getByText('Projekt und CPU sind gleich.').waitFor();
  await turn(page, 'RUN-P');
  await visit(page, server, 'hardware');
  await page.getByRole('tab', { name: 'Konfigurieren' }).click();
  await page.getByText('Noch kein Aufbau').waitFor();
  assert.equal(await page.locator('.message').filter({ hasText: 'P1310' }).count(), 0, 'a file of the project before');
});

test('a module is dragged from the catalogue to a slot and has its address (S7-HWCFG-01, S7-HWCFG-02)', async () => {
  await page.getByRole('searchbox', { name: 'Katalog filtern' }).fill('321-1BH02');
  await catalogue(/DI16xDC24V/).dragTo(slot(4));
  await shows(4, /SM 321 DI16xDC24V/);
  await shows(4, /0…1/);
  await page.getByText('nicht gespeichert').waitFor();
});

test('the keyboard places one as well, and slots that do not fit say why (S7-HWCFG-01, S7-HWCFG-07)', async () => {
  await page.getByRole('searchbox', { name: 'Katalog filtern' }).fill('322-1BH01');
  await catalogue(/DO16xDC24V/).focus();
  await page.keyboard.press('Enter');
  await slot(3).getByRole('button').focus();
  await page.keyboard.press('Enter');
  await says('Steckplätzen 4 bis 11');
  assert.match(await inSlot(3), /frei/);
  await page.keyboard.press('Escape');
  await catalogue(/DO16xDC24V/).focus();
  await page.keyboard.press('Enter');
  await slot(6).getByRole('button').focus();
  await page.keyboard.press('Enter');
  await shows(6, /SM 322/);
  await shows(6, /8…9/);
  // The gap is told with its slot.
  await page.getByRole('region', { name: 'Konsistenz' }).getByText('P0732').waitFor();
  await slot(6).getByRole('button').focus();
  await page.keyboard.press('Alt+ArrowUp');
  await shows(5, /SM 322/);
  await page.getByText('Die Konfiguration ist konsistent.').waitFor();
});

test('addresses change freely, what is not possible stays marked and changes nothing (S7-HWCFG-03)', async () => {
  await slot(4).getByRole('button').click();
  const start = page.getByLabel('Anfangsadresse E');
  await start.fill('124');
  await start.press('Enter');
  await says('überschneiden');
  await expect(() => start.getAttribute('aria-invalid'), 'true');
  assert.equal(await start.inputValue(), '124');
  await shows(4, /0…1/);
  await start.press('Escape');
  await expect(() => start.inputValue(), '');
  await start.fill('10');
  await start.press('Enter');
  await shows(4, /10…11/);
});

test('parameters of modules and CPU (S7-HWCFG-08, S7-HWCFG-09)', async () => {
  await page.getByLabel('Name', { exact: true }).fill('Panel');
  await page.getByLabel('Name', { exact: true }).press('Enter');
  await shows(4, /Panel/);
  await slot('2.3').getByRole('button').click();
  await page.getByLabel('Kanal AI1: Messbereich').selectOption('0..10V');
  await picture(page, 'hardware-configure');
  await slot(2).getByRole('button').click();
  // Both before the server has answered the first.
  await page.getByLabel('OB 35: Zeittakt').waitFor();
  await page.evaluate((typed) => {
    for (const [name, value] of typed) {
      const field = document.querySelector(`input[aria-label="${name}"]`);
      field.value = value;
      field.dispatchEvent(new Event('change', { bubbles: true }));
    }
  }, [['MPI-Adresse', '4'], ['OB 35: Zeittakt', '50ms']]);
  await accessible(page, 'configure');
});

// POS-OVW-17, POS-OVW-18, POS-PARAM-15, POS-PARAM-31
test('an axis: AO 0 off, the drive, and the pages of this drive', async () => {
  const mask = (name) => page.getByRole('tab', { name, exact: true });
  await slot('2.5').getByRole('button').click();
  await page.getByLabel('Betriebsart', { exact: true }).selectOption('analog');
  await says('AO 0 gehört der Achse');
  await slot('2.3').getByRole('button').click();
  await page.getByLabel('Kanal AO0: Messbereich').selectOption('off');
  await slot('2.5').getByRole('button').click();
  await page.getByLabel('Betriebsart', { exact: true }).selectOption('analog');
  for (const name of ['Grundparameter', 'Antrieb', 'Achse', 'Geber', 'Diagnose']) await mask(name).waitFor();
  await mask('Antrieb').click();
  const speed = page.getByLabel('Maximalgeschwindigkeit (Impulse/s)');
  await speed.fill('10000');
  await speed.press('Enter');
  await mask('Achse').click();
  await page.getByLabel('Achsart', { exact: true }).selectOption('rotary');
  await page.getByLabel('Rundachsenende (Impulse)').waitFor();
  assert.equal(await page.getByLabel('Softwareendschalter Anfang').count(), 0);
  const end = page.getByLabel('Rundachsenende (Impulse)');
  await end.fill('8000');
  await end.press('Enter');
  await mask('Grundparameter').click();
  await page.getByLabel('Betriebsart', { exact: true }).selectOption('digital');
  await mask('Antrieb').click();
  await page.getByLabel('Ansteuerart 1 bis 4').waitFor();
  assert.equal(await speed.count(), 0);
  await mask('Grundparameter').click();
  await page.getByLabel('Betriebsart', { exact: true }).selectOption('none');
  await until(async () => (await mask('Antrieb').count()) === 0, 'no axis any more');
});

// CNT-PARAM-01 to -19: a mask for each channel.
test('a counting channel has the mask of its mode', async () => {
  await slot('2.4').getByRole('button').click();
  await page.getByRole('tab', { name: 'Kanal 3', exact: true }).waitFor();
  await page.getByRole('tab', { name: 'Kanal 1', exact: true }).click();
  const field = (name) => page.getByLabel(name, { exact: true });
  await field('Betriebsart').selectOption({ label: 'Periodisch zählen' });
  await field('Hauptzählrichtung').selectOption({ label: 'vorwärts' });
  await field('Endwert').fill('100');
  await field('Endwert').press('Enter');
  await field('Vergleichswert').fill('100');
  await field('Vergleichswert').press('Enter');
  await says('„Vergleichswert“ muss sein');
  await says('-2147483648 bis 99');
  await expect(() => field('Vergleichswert').getAttribute('aria-invalid'), 'true');
  assert.equal(await field('Vergleichswert').inputValue(), '100', 'what was typed stays');
  await field('Vergleichswert').fill('50');
  await field('Vergleichswert').press('Enter');
  await expect(() => field('Vergleichswert').getAttribute('aria-invalid'), null);
  const causes = page.getByRole('group', { name: 'Prozessalarm' });
  await causes.getByLabel('Überlauf').check();
  // What is set is in sight beside the module that it is set on, and says what it needs.
  for (const part of [causes.getByLabel('Zählflanke'), slot('2.4'), field('Betriebsart')]) {
    await part.scrollIntoViewIfNeeded();
    const [where, there] = [await slot('2.4').boundingBox(), await part.boundingBox()];
    for (const box of [where, there]) assert.ok(box.y > 0 && box.y + box.height < 800, JSON.stringify({ where, there }));
  }
  const needs = page.getByText('setzen oben „Alarme“ mit Prozess voraus');
  await needs.waitFor();
  await field('Alarme').selectOption({ label: 'Prozess' });
  await expect(() => needs.count(), 0);
  await accessible(page, 'masks of a counting channel');
  await page.getByRole('tab', { name: 'Kanal 1', exact: true }).scrollIntoViewIfNeeded();
  await picture(page, 'hardware-counting');
  await field('Betriebsart').selectOption({ label: 'Pulsweitenmodulation' });
  await field('Periodendauer').waitFor();
  assert.equal(await field('Endwert').count(), 0);
  await field('Betriebsart').selectOption({ label: 'nicht parametriert' });
  await until(async () => (await field('Periodendauer').count()) === 0, 'nothing more to set');
});

test('a change is taken back', async () => {
  await slot(5).getByRole('button').focus();
  await page.keyboard.press('Delete');
  await shows(5, /frei/);
  await page.getByRole('button', { name: 'Rückgängig' }).click();
  await shows(5, /SM 322/);
});

test('save and compile writes merker.toml (S7-HWCFG-07)', async () => {
  await page.getByRole('button', { name: 'Speichern und übersetzen' }).click();
  await says('Gespeichert und übersetzt');
  for (const line of ['name = "By hand"', 'mpi_address = 4', 'slot = 4', 'input = 10', 'name = "Panel"', '[cpu.OB35]', 'interval = "50ms"', 'range = "0..10V"'])
    await until(() => settings().includes(line), () => `${line} in ${settings()}`);
});

test('it is loaded in STOP, and the CPU works with the new address (S7-HWCFG-03)', async () => {
  await page.getByRole('button', { name: 'In die CPU laden' }).click();
  await page.getByText('Force-Aufträge, Uhrzeit und Diagnosepuffer bleiben').waitFor();
  await page.getByRole('button', { name: 'STOP und laden' }).click();
  await says('Konfiguration geladen');
  // The switch has not moved, and the STOP is that of the programming device.
  assert.equal(await page.getByRole('radio', { name: 'RUN-P', exact: true }).getAttribute('aria-checked'), 'true');
  await page.getByRole('button', { name: 'Neustart' }).click();
  await page.locator('[data-mode="RUN"]').waitFor();
  await page.getByRole('tab', { name: 'Im Betrieb' }).click();
  await page.getByRole('button', { name: 'Steckplatz 4: SM 321 DI16xDC24V' }).click();
  await page.getByRole('table', { name: 'Klemmen' }).getByText('E 10.0', { exact: true }).waitFor();
  await visit(page, server, 'io');
  await page.locator('#tile-operand').fill('EB 10');
  await page.locator('#tile-operand').press('Enter');
  await page.locator('button[data-operand="E 10.0"]').first().click();
  await expect(() => bit(page, 'E 10.0'), '1', 'the input of the new module');
});

test('comments of merker.toml stay where they are', async () => {
  await visit(page, server, 'projects');
  await page.getByRole('searchbox').fill('hardware');
  await page.getByRole('button', { name: /^Öffnen: / }).first().click();
  await until(async () => (await page.locator('.root > strong').innerText()) !== 'By hand', 'another project');
  const folder = await page.locator('.folder .mono').innerText();
  const file = () => readFileSync(join(folder, 'merker.toml'), 'utf-8');
  const before = file();
  await visit(page, server, 'hardware?mode=plan');
  await slot(4).getByRole('button').click();
  await page.getByLabel('Name', { exact: true }).fill('Somewhere else');
  await page.getByLabel('Name', { exact: true }).press('Enter');
  await page.getByRole('button', { name: 'Speichern', exact: true }).click();
  await until(() => /name = "Somewhere else"/.test(file()), 'the saved name');
  const comments = (text) => text.match(/#.*/g) ?? [];
  assert.deepEqual(comments(file()), comments(before));
});
