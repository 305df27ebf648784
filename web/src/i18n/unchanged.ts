// For the tests: English literals of the program's sources that need no German.
export const unchanged = [
  // values that a user writes in merker.toml
  ', off',
  'range = "4..20mA"',
  'main_direction = "forward"',
  'main_direction = "backward"',
  'gate closed',
  'end of measurement',
  'low limit',
  'high limit',
  'per mille',
  'diagnostics and process',
  'end of month',
  'each cycle',
  'coming and going',
  'Type K',
  'Type J',
  'Type E',
  'Type N',
  'Type L',
  'Pt100 climatic',
  'Ni100 climatic',
  // texts of sources and files
  'Network 1',
  'Netzwerk 1',
  '[project] name = "{}"  [cpu] model = "{}" mpi_address = {}',
  'type = "{}"',
  '126,Motor                   A       1.0 BOOL',
  'TABLE  0,1  "Merker"  VECTORS  0,{}  ""  TUPLES  0,4  ""  DATA  0,0  ""',
  // the listing of machine code, of the command line
  '{:<4} : illegal {:04X}',
  // parts of phrases: "no analog inputs", "the binary input signal X", ": rack 1"
  'no analog {}s',
  '{} {} signal {}',
  ': address {}',
  ': rack',
];
