#ifndef continua_analysis_answer_h
#define continua_analysis_answer_h

#include <continua/base/summary.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * What a run ends with on the screen, from its summary: wave speeds and attenuation, simulated
 * beside theory and measurement; of each probe the largest and smallest value with their times and
 * the frequency, or the final value of a steady state; the moduli of a material; each check with
 * its value, its band and its verdict. SI units, as in summary.json, which has all of it and more;
 * a table of many probes is cut short, and says so.
 */
std::vector<std::string> answer_lines(const Summary &summary);
} // namespace Continua

#endif
