// What a person sees at once: nothing lies on something else, nothing is cut off.

/** What is touched or read in the view that overlaps, that crosses a frame of the drawing, or that is out of sight at the right. */
export const crowding = (page) =>
  page.evaluate(() => {
    const TOUCHED = 'button, input, select, a[href], [role="tab"], [role="switch"]';
    /** A common border is no overlap. */
    const SLACK = 1.5;
    const said = (one) => `<${one.tagName.toLowerCase()}> ${(one.getAttribute('aria-label') ?? one.textContent).trim().slice(0, 40)}`;
    const box = (one) => ({ one, rect: one.getBoundingClientRect() });
    const shown = (one) =>
      one.checkVisibility({ visibilityProperty: true }) && !one.closest('.visually-hidden, .skip, .cm-editor') && one.getBoundingClientRect().width > 1;
    const boxes = (selector) => [...document.querySelectorAll(selector)].filter(shown).map(box);
    const meet = (a, b) =>
      Math.min(a.right, b.right) - Math.max(a.left, b.left) > SLACK && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > SLACK;
    const holds = (a, b) => a.left <= b.left && a.top <= b.top && a.right >= b.right && a.bottom >= b.bottom;
    const scroller = (one) => {
      for (let up = one.parentElement; up; up = up.parentElement) if (/auto|scroll|hidden/.test(getComputedStyle(up).overflow)) return up;
      return null;
    };
    const found = [];

    const touched = boxes(TOUCHED);
    for (const [index, a] of touched.entries())
      for (const b of touched.slice(index + 1))
        if (scroller(a.one) === scroller(b.one) && !a.one.contains(b.one) && meet(a.rect, b.rect)) found.push(`${said(a.one)} lies on ${said(b.one)}`);

    const written = boxes('main span, main label, main th').filter(({ one }) => one.childElementCount === 0 && one.textContent.trim());
    for (const text of written)
      for (const control of touched)
        if (scroller(text.one) === scroller(control.one) && !control.one.contains(text.one) && !text.one.contains(control.one) && meet(text.rect, control.rect))
          found.push(`${said(text.one)} lies on ${said(control.one)}`);
    for (const { one, rect } of [...touched, ...written]) {
      const frame = one.closest('.plate')?.getBoundingClientRect();
      if (frame && scroller(one) === scroller(one.closest('.plate')) && rect.right > frame.right + 1) found.push(`${said(one)} leaves its plate`);
    }

    const plates = boxes('[data-plant] button');
    for (const plate of plates) {
      for (const { one, rect } of boxes('[data-plant] > svg text, [data-plant] > svg circle'))
        if (meet(plate.rect, rect)) found.push(`${said(plate.one)} hides ${said(one)}`);
      for (const { one, rect } of boxes('[data-plant] > svg rect'))
        if (meet(plate.rect, rect) && !holds(rect, plate.rect)) found.push(`${said(plate.one)} crosses ${one.outerHTML.slice(0, 90)}`);
      const stage = plate.one.closest('[data-plant]').getBoundingClientRect();
      if (!holds(stage, plate.rect)) found.push(`${said(plate.one)} leaves the picture`);
    }

    // Long texts may be cut with dots, source text and curves scroll in their own frame.
    for (const one of document.querySelectorAll('body *')) {
      const { overflowX, textOverflow } = getComputedStyle(one);
      if (overflowX === 'visible' || textOverflow === 'ellipsis' || !shown(one) || one.matches('input, select, .paper')) continue;
      if (one.scrollWidth > one.clientWidth + 1) found.push(`<${one.tagName.toLowerCase()} class="${one.className}"> is cut: ${one.scrollWidth} of ${one.clientWidth} px`);
    }
    for (const { one, rect } of boxes(`${TOUCHED}, th, td`)) if (rect.right > innerWidth + 1 || rect.left < -1) found.push(`${said(one)} is beyond the edge`);
    return found;
  });

/** What a finger needs (WCAG 2.5.5 has 44 px; docs/workbench.md 40 px); a line of a table has its edge in it. */
const FINGER = 39;

/** What is pressed in the view and lower than a finger needs; a box to be ticked is pressed with its label.
 *  Edges that are moved have their own room (Splitter.svelte), the text of a program is none. */
export const low = (page) =>
  page.evaluate((finger) => {
    const PRESSED = 'button, input, select, textarea, a[href], [role="tab"], [role="switch"], [role="treeitem"]';
    const shown = (one) =>
      one.checkVisibility({ visibilityProperty: true }) && !one.closest('.visually-hidden, .skip, .cm-editor') && one.getBoundingClientRect().width > 1;
    return [...document.querySelectorAll(PRESSED)].filter(shown).flatMap((one) => {
      const { height } = (one.closest('label') ?? one).getBoundingClientRect();
      const said = (one.getAttribute('aria-label') ?? one.textContent).trim().slice(0, 40);
      return height < finger ? [`<${one.tagName.toLowerCase()} class="${one.className?.baseVal ?? one.className}" in ${one.parentElement.className || one.parentElement.tagName}> ${said}: ${Math.round(height)} px`] : [];
    });
  }, FINGER);
