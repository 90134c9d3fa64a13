#include "observe/page/text_table.hpp"

#include <boost/json.hpp>

namespace placedpar::page {

boost::json::array TextTable::json() const { return boost::json::array(texts_.begin(), texts_.end()); }

} // namespace placedpar::page
