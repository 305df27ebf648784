// What stands below the text.
export type Panel = 'problems' | 'watch' | 'search' | 'references' | 'code' | 'difference';
