// What stands below the text.
export type Panel = 'problems' | 'references' | 'code' | 'difference';
