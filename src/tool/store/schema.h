// The tables of a card. A card is trusted no further than these: one that has anything else, or
// something of another form, is not read.
#pragma once

#include "store/database.h"

namespace merker::store {

// All in one transaction with the old journal, so that the header of the file says what it is from
// the beginning.
void createTables(Database& database);
// Throws Damage if the tables are not exactly those of a card. Nothing but the names and the texts
// of the schema is read for that.
void requireTables(Database& database);

}  // namespace merker::store
