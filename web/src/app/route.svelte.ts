/** Where the page stands: `#/program?file=sorting.awl&line=12`. */
export interface Route {
  view: string;
  params: Record<string, string>;
}

export function parseRoute(hash: string): Route {
  const [path = '', query = ''] = hash.replace(/^#\/?/, '').split('?', 2);
  return { view: path, params: Object.fromEntries(new URLSearchParams(query)) };
}

export function printRoute({ view, params }: Route): string {
  const query = new URLSearchParams(params).toString();
  return `#/${view}${query ? `?${query}` : ''}`;
}

let current = $state<Route>({ view: '', params: {} });

export const route = {
  get view() {
    return current.view;
  },
  get params() {
    return current.params;
  },
};

/** Goes to a view; `params` say what in it, e.g. file and line of the program view. */
export function go(view: string, params: Record<string, string | number> = {}): void {
  const texts = Object.fromEntries(Object.entries(params).map(([name, value]) => [name, String(value)]));
  location.hash = printRoute({ view, params: texts });
}

export function followHash(): void {
  const follow = () => (current = parseRoute(location.hash));
  window.addEventListener('hashchange', follow);
  follow();
}
