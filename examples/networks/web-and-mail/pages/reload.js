// The values come again each second, without the page.
const show = (id, text) => (document.getElementById(id).textContent = text)

async function reload() {
  const values = await (await fetch('values.json')).json()
  const cpu = await (await fetch('cpu.json')).json()
  document.getElementById('bar').style.height = `${values.level}%`
  show('level', values.level)
  show('motor', values.motor ? 'on' : 'off')
  show('alarm', values.alarm ? 'full' : '-')
  show('mode', cpu.mode)
}

const again = () => reload().catch(() => show('mode', 'no answer'))
again()
setInterval(again, 1000)
