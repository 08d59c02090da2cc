#include "core/reproduction/figure_record.h"
namespace gonio::reproduction {
std::vector<FigureRecord> acquisitionFigures() { return {}; }
}
