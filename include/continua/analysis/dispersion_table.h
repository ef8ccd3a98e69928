#ifndef continua_analysis_dispersion_table_h
#define continua_analysis_dispersion_table_h

#include <continua/theory/tube_section.h>

#include <string>

namespace Continua
{
/**
 * Writes how the waves of a tube's section depend on frequency: phase speed omega / Re k, group
 * speed d omega / d Re k [m/s] and attenuation -Im k [1/m] of the exact pressure and axial waves,
 * wave number and attenuation of the bending waves [1/m], and beside them speed and attenuation of
 * the pressure wave by the closed formula, the membrane and Womersley's theory. 80 rows, evenly in
 * the logarithm of the frequency, from where waves are long to the highest frequency [Hz]. Where a
 * closed formula has no wave its cells are empty (nan). `only_long_waves`: the columns of
 * Womersley's theory alone, for a wall that stands for another one. Throws RunError when the disk
 * refuses.
 */
void write_dispersion_table(const std::string &file,
                            const TubeSection &section,
                            double highest_frequency,
                            bool only_long_waves = false);
} // namespace Continua

#endif
