// Exact waves in tubes: roots and quantities from scripts/references/waves/exact_dispersion.py, which
// solves other equations by other means with 50 digits and more; limits in closed form; the
// balances of mass and momentum over a section.

#include <continua/theory/complex_bessel.h>
#include <continua/theory/exact_dispersion.h>

#include "../unit_test.h"

#include <limits>

namespace test_of_exact_dispersion
{
using namespace Continua;

namespace
{
constexpr double pi = 3.14159265358979323846;
const Complex imaginary(0., 1.);

Material solid(const double density, const double young, const double poisson)
{
  Material material;
  material.density = density;
  material.compression = Compression::elastic(3. * (1. - 2. * poisson) / young);
  material.shear.branches = {Branch{young / (2. * (1. + poisson))}};
  return material;
}

Material
liquid(const double density, const double viscosity, const double inverse_bulk_modulus = 0.)
{
  Material material;
  material.density = density;
  material.shear.viscosity = viscosity;
  material.compression = Compression::elastic(inverse_bulk_modulus);
  return material;
}

Material power_law(const double density, const double modulus, const double exponent)
{
  Material material;
  material.density = density;
  material.shear.power_law = PowerLaw{modulus, exponent, {}, {}};
  return material;
}

TubeSection tube(const double radius,
                 const Material &fluid,
                 const std::vector<double> &thicknesses,
                 const std::vector<Material> &layers,
                 const bool tethered = false)
{
  TubeSection section;
  section.inner_radius = radius;
  section.fluid = fluid;
  section.layer_thicknesses = thicknesses;
  section.layers = layers;
  section.tethered = tethered;
  return section;
}

const Material water = liquid(998., 1e-3, 1. / 2.2e9), oil = liquid(870., 0.1, 1. / 1.5e9),
               blood = liquid(1060., 4e-3, 1. / 2.2e9);

Complex root(const TubeSection &section, const Complex omega, const Complex start)
{
  Complex k;
  if (!ExactDispersion(section).find_root(omega, start, k))
    return std::numeric_limits<double>::quiet_NaN();
  return k;
}

/// The root near the family's own guess.
Complex guessed(const TubeSection &section,
                const Complex omega,
                const ExactDispersion::Family family = ExactDispersion::pressure_wave)
{
  return root(section, omega, ExactDispersion(section).guess(family, omega));
}

void close(const std::string &name,
           const Complex value,
           const Complex reference,
           const double tolerance)
{
  check::absolute(name, std::abs(value - reference) / std::abs(reference), 0., tolerance);
}

/// A root of the script, and the displacement, shear stress, force, moment and hoop stress it
/// prints.
void reference(const std::string &name,
               const TubeSection &section,
               const double frequency,
               const double decay,
               const ExactDispersion::Family family,
               const Complex k,
               const std::vector<Complex> &quantities = {})
{
  const Complex omega(2. * pi * frequency, -decay);
  close(name, root(section, omega, k * Complex(1.02, 0.01)), k, 1e-9);
  if (quantities.empty())
    return;
  const WaveMode mode = ExactDispersion(section).mode(family, omega, k);
  const double area = pi * section.inner_radius * section.inner_radius;
  const Complex mean = mode.junction[WaveMode::flow_rate] / (imaginary * omega * area);
  close(name + ", displacement", mode.wall_displacement / mean, quantities[0], 1e-9);
  close(name + ", shear stress", mode.wall_shear_stress / mean, quantities[1], 1e-9);
  // These the class has from three Gauss points a layer.
  close(name + ", moment", mode.junction[WaveMode::bending_moment] / mean, quantities[2], 2e-3);
  close(name + ", hoop stress", mode.hoop_stress / mean, quantities[3], 1e-5);
}

void references()
{
  const TubeSection thin = tube(12.5e-3, water, {0.1e-3}, {solid(880., 1.72e6, 0.49)});
  const TubeSection tube_3d = tube(5e-3, liquid(1000., 3e-3), {1e-3}, {solid(1200., 3e5, 0.3)});
  const TubeSection tube_3d_held =
      tube(5e-3, liquid(1000., 3e-3), {1e-3}, {solid(1200., 3e5, 0.3)}, true);
  const TubeSection thick = tube(12.5e-3, blood, {5e-3}, {solid(1100., 1e6, 0.49)});
  const TubeSection membrane =
      tube(0.01, liquid(1050., 1e-5), {1e-5}, {solid(1000., 60e6, 0.5)}, true);
  const TubeSection steel = tube(0.1, oil, {5e-3}, {solid(7850., 200e9, 0.3)});
  const TubeSection power_law_wall = tube(12.5e-3, blood, {1e-3}, {power_law(880., 1.3e6, 0.065)});
  Material constant_ratio = power_law(880., 1.3e6, 0.065);
  constant_ratio.shear.power_law->poissons_ratio = 0.3;
  const TubeSection power_law_nu = tube(12.5e-3, blood, {1e-3}, {constant_ratio});
  Material middle;
  middle.density = 1050.;
  middle.compression = Compression::elastic(1e-9);
  middle.shear.branches = {Branch{0.4e6}, Branch{0.3e6, 5e-3}};
  const TubeSection layered = tube(9e-3, blood, {0.2e-3, 0.9e-3, 0.5e-3},
                                   {solid(1100., 0.3e6, 0.49), middle, solid(1000., 1.2e6, 0.45)});
  const TubeSection rigid = tube(1e-3, water, {}, {});
  const TubeSection inviscid =
      tube(12.5e-3, liquid(998., 0., 1. / 2.2e9), {1e-3}, {solid(880., 1.72e6, 0.49)});
  reference("thin, 10 Hz, pressure", thin, 10., 0., ExactDispersion::pressure_wave,
            Complex(24.27713345573495, -0.1042905548865973),
            {Complex(0.0006518127686788212, 0.1517316179718395),
             Complex(270.280692191357, -277.3617796586129),
             Complex(1.700649735606812e-08, 1.324000402703608e-06),
             Complex(144285.6093777419, 20751196.47398382)});
  reference("thin, 10 Hz, axial", thin, 10., 0., ExactDispersion::axial_wave,
            Complex(1.813501950926012, -0.432799583466652),
            {Complex(0.002702622944270173, 0.01133693546948527),
             Complex(-37052.38664907042, -7046.996151809944),
             Complex(3.669566982855096e-10, 1.119365420594055e-09),
             Complex(104479798.6530623, -112130904.642233)});
  reference("thin, 10 Hz, bending", thin, 10., 0., ExactDispersion::bending_wave,
            Complex(1094.550325463282, -1097.952863285989),
            {Complex(6.862205399582993, 6.840939528240832),
             Complex(1253.634146679466, -4526.839296019975),
             Complex(0.2444961297573615, -0.2444224622359375),
             Complex(939863941.865879, 934534374.5598263)});
  reference("thin, 20 Hz, pressure", thin, 20., 28., ExactDispersion::pressure_wave,
            Complex(49.16122426930649, -11.65488897853958),
            {Complex(0.07284285769943746, 0.3072567346749482),
             Complex(485.3416973471281, -1074.937964684354),
             Complex(7.674166800770293e-06, 9.141570147604487e-06),
             Complex(10027092.36078459, 41981416.86596366)});
  reference("thin, 20 Hz, axial", thin, 20., 28., ExactDispersion::axial_wave,
            Complex(3.234486893441744, -1.325591530455883),
            {Complex(0.008279493572191548, 0.02022432766726447),
             Complex(-172022.427632554, 30706.48066933777),
             Complex(6.368915206345197e-09, 6.914820162040062e-09),
             Complex(239945721.2615905, -386611498.7101106)});
  reference("thin, 20 Hz, bending", thin, 20., 28., ExactDispersion::bending_wave,
            Complex(1091.992569903664, -1095.672516242005),
            {Complex(6.847953233187658, 6.82495353186838),
             Complex(-1619.772641242853, -13305.15749027489),
             Complex(0.2427807658139152, -0.2429084129207958),
             Complex(937919360.6132563, 932351113.1142362)});
  reference("thin, 200 Hz, pressure", thin, 200., 0., ExactDispersion::pressure_wave,
            Complex(1218.096188244802, -11.88296397052378),
            {Complex(0.07426847233328948, 7.61309741710717),
             Complex(223762.5070157218, -215619.3607546813),
             Complex(0.004878889599221637, 0.1670655759990216),
             Complex(10975564.08423958, 1040383323.636199)});
  reference("thin, 200 Hz, axial", thin, 200., 0., ExactDispersion::axial_wave,
            Complex(27.60204916925708, -2.533814946033136),
            {Complex(0.01558750846641939, 0.1724408546315319),
             Complex(-6867675.872701995, -15511460.35062089),
             Complex(-5.075381437224067e-06, 3.282895342731818e-06),
             Complex(11106192050.45779, 3187928896.270438)});
  reference("tube-3d, 20 Hz, pressure", tube_3d, 20., 0., ExactDispersion::pressure_wave,
            Complex(25.36337000739791, -0.4400824935630283),
            {Complex(0.001100206233907571, 0.06340842501849478),
             Complex(1501.147201116121, -1634.127876346176),
             Complex(1.742824382214166e-06, 3.557451073177326e-05),
             Complex(72977.2872717519, 3235690.309505035)});
  reference("tube-3d, 20 Hz, axial", tube_3d, 20., 0., ExactDispersion::axial_wave,
            Complex(7.991103863874353, -0.3385706230859913),
            {Complex(0.0008464265577149782, 0.01997775965968588),
             Complex(-15095.19123804409, -48894.1873349356),
             Complex(-2.422861272920065e-06, 7.645645823925477e-07),
             Complex(11919078.48594926, 6591706.679333893)});
  reference("tube-3d, 20 Hz, bending", tube_3d, 20., 0., ExactDispersion::bending_wave,
            Complex(531.838252043989, -565.2428239467772),
            {Complex(1.413107059866943, 1.329595630109973),
             Complex(2084.787993356604, -3681.078999510553),
             Complex(0.7827661794434071, -0.7388366816232187),
             Complex(76359535.51261064, 69507427.54234333)});
  reference("tube-3d, 100 Hz, pressure", tube_3d, 100., 0., ExactDispersion::pressure_wave,
            Complex(131.8279898989126, -1.0625359142639),
            {Complex(0.002656339785659751, 0.3295699747472815),
             Complex(17404.62054348056, -17953.03763043932),
             Complex(0.0001146575699451792, 0.005012277834058202),
             Complex(171562.0361161019, 16817188.15144332)});
  reference("tube-3d, 100 Hz, axial", tube_3d, 100., 0., ExactDispersion::axial_wave,
            Complex(38.97159459068368, -0.7803441480689532),
            {Complex(0.001950860370172383, 0.09742898647670921),
             Complex(215369.3240487727, -516631.5405754852),
             Complex(-0.000127365767427797, -7.57084323616405e-05),
             Complex(25083448.46796708, 62129370.06821802)});
  reference("tube-3d, 100 Hz, bending", tube_3d, 100., 0., ExactDispersion::bending_wave,
            Complex(515.8003158266245, -558.3170922358735),
            {Complex(1.395792730589684, 1.289500789566561),
             Complex(18132.91650231435, -39684.54201344413),
             Complex(0.7131965492683736, -0.7200523081190633),
             Complex(75362961.53437765, 67201462.3537875)});
  reference("tube-3d, 167 Hz, pressure", tube_3d, 167., 0., ExactDispersion::pressure_wave,
            Complex(241.8000956811928, -1.691621556007486),
            {Complex(0.004229053890018714, 0.604500239202982),
             Complex(40407.59523265458, -40938.34560854143),
             Complex(0.0006186549386698005, 0.03092948921549755),
             Complex(260879.0559042632, 30989963.406545)});
  reference("tube-3d, 167 Hz, axial", tube_3d, 167., 0., ExactDispersion::axial_wave,
            Complex(64.78535624374408, -1.014809624511741),
            {Complex(0.002537024061279352, 0.1619633906093602),
             Complex(557224.5969452242, -1010102.44411786),
             Complex(-0.0004115994281107575, -0.0003466094678552048),
             Complex(29144236.35073229, 102811606.4312084)});
  reference("tube-3d, 167 Hz, bending", tube_3d, 167., 0., ExactDispersion::bending_wave,
            Complex(481.428524482558, -547.7604984143413),
            {Complex(1.369401246035854, 1.203571311206395),
             Complex(33837.95571269426, -83958.65844256457),
             Complex(0.575688250445329, -0.6918687368849296),
             Complex(73811874.88720124, 62295277.42634447)});
  reference("tube-3d-held, 20 Hz, pressure", tube_3d_held, 20., 0., ExactDispersion::pressure_wave,
            Complex(24.49912030515845, -0.5480117855384807),
            {Complex(0.001370029463846202, 0.06124780076289611),
             Complex(1722.665036065892, -1841.353869175086),
             Complex(2.021580463116896e-06, 3.327313524166086e-05),
             Complex(75294.49669470197, 3368657.610021191)});
  TubeSection supported = tube_3d;
  supported.radial_stiffness = 6e6;
  supported.radial_damping = 300.;
  supported.axial_stiffness = 2e5;
  supported.axial_damping = 30.;
  TubeSection supported_held = tube_3d_held;
  supported_held.radial_stiffness = 6e6;
  supported_held.radial_damping = 300.;
  reference("supported, 20 Hz, pressure", supported, 20., 0., ExactDispersion::pressure_wave,
            Complex(19.841446234052334767, -0.44173592808968968201),
            {Complex(0.001104339820224224205, 0.049603615585130836919),
             Complex(1659.5296913359461757, -1786.7250112427736944),
             Complex(9.7302564591540952479e-7, 1.6760108802337879661e-5),
             Complex(62936.647727553296888, 2533598.771844350142)});
  reference("supported, 20 Hz, bending", supported, 20., 0., ExactDispersion::bending_wave,
            Complex(594.93007406326343214, -642.57505589699750673),
            {Complex(1.6064376397424937668, 1.4873251851581585804),
             Complex(2551.7998777232648479, -4021.3087619294059132),
             Complex(1.1304347794507955109, -1.0484097928161495472),
             Complex(85469181.335982426756, 75798815.223065463783)});
  reference("supported, 100 Hz, pressure", supported, 100., 50., ExactDispersion::pressure_wave,
            Complex(101.84589303218863323, -10.091248750898740368),
            {Complex(0.025228121877246850921, 0.25461473258047158306),
             Complex(15379.738493378241514, -20343.543843958508963),
             Complex(6.604338709402343717e-4, 0.0021744115889168586122),
             Complex(1285818.8114335062922, 12453285.360941157255)});
  // Of the root alone: a double does not have the digits of it that the quantities need.
  reference("supported, 100 Hz, axial", supported, 100., 50., ExactDispersion::axial_wave,
            Complex(29.334384252287597562, -6.1251760987821618574));
  reference("supported and held, 100 Hz", supported_held, 100., 0., ExactDispersion::pressure_wave,
            Complex(100.71031707380688231, -1.6005693629605545445),
            {Complex(0.0040014234074013863613, 0.25177579268451720578),
             Complex(19400.441777353145284, -19923.174871756922296),
             Complex(9.900781086598487453e-5, 0.0022262944607311766928),
             Complex(226990.02088205463049, 13075175.953321859149)});
  reference("thick, 5 Hz, pressure", thick, 5., 30., ExactDispersion::pressure_wave,
            Complex(2.789175938474627, -2.70119072388032),
            {Complex(0.01688138326490803, 0.01743126105143396),
             Complex(-188.2600088256991, -477.8583830246043),
             Complex(0.0002778156666334451, -0.000251194745422446),
             Complex(922388.6639721373, 946822.7102759918)});
  reference("thick, 5 Hz, axial", thick, 5., 30., ExactDispersion::axial_wave,
            Complex(0.9714573755621837, -0.9493611493312943),
            {Complex(0.00592875270699571, 0.006068078825093788),
             Complex(-2962.43213480187, -5045.731146328299),
             Complex(-6.430819362632952e-06, 1.722393615683609e-05),
             Complex(4138243.207882384, 3072874.189356266)});
  reference("thick, 5 Hz, bending", thick, 5., 30., ExactDispersion::bending_wave,
            Complex(135.7136683573285, -150.2263544223117),
            {Complex(0.9389146962101301, 0.8482104052448357),
             Complex(-209.2904567232488, -498.7229044843669),
             Complex(45.25534292821537, -40.82583131744762),
             Complex(61307492.35229082, 49708537.57977976)});
  reference("thick, 100 Hz, pressure", thick, 100., 0., ExactDispersion::pressure_wave,
            Complex(60.01113122147603, -0.1841329827279404),
            {Complex(0.001150742180688481, 0.375049611926337),
             Complex(19491.68196061159, -19716.86355341683),
             Complex(0.01142040477595719, 1.392018574649127),
             Complex(86502.90070262915, 20691249.29301689)});
  reference("thick, 100 Hz, axial", thick, 100., 0., ExactDispersion::axial_wave,
            Complex(19.23126004661581, -0.1106925872952921),
            {Complex(0.0006878905353280018, 0.1201297083131964),
             Complex(161885.1513985043, -182597.5161012879),
             Complex(-0.006787019132783558, -0.01606687135544487),
             Complex(3312581.46243557, 56366830.02745795)});
  reference("thick, 100 Hz, bending", thick, 100., 0., ExactDispersion::bending_wave,
            Complex(128.0194744796112, -146.6568970530849),
            {Complex(0.9166102018919121, 0.8001176362611337),
             Complex(17276.88336928511, -22070.56229766743),
             Complex(37.70306346077147, -39.60183566874971),
             Complex(59732212.35684731, 45915437.81261585)});
  reference("membrane, 2 Hz, pressure", membrane, 2., 0., ExactDispersion::pressure_wave,
            Complex(2.041531475071194, -0.003982284769715828));
  reference("steel, 50 Hz, pressure", steel, 50., 0., ExactDispersion::pressure_wave,
            Complex(0.2753115920652454, -0.001101303703811219),
            {Complex(1.000206925676578e-05, 0.003283439622576754),
             Complex(35429.61416479477, -35925.44898595316),
             Complex(0.003903343978258075, 0.3565814931471007),
             Complex(27037844.97803554, 6288410510.085585)});
  reference("steel, 50 Hz, axial", steel, 50., 0., ExactDispersion::axial_wave,
            Complex(0.06188195251347477, -0.0003006193423489076),
            {Complex(-0.02050460624897744, -0.05268501459132761),
             Complex(875049.7191139682, -1929845.303880804),
             Complex(-0.07652009947217459, -0.185823164843864),
             Complex(12306765659.61966, 33454097544.61079)});
  reference("steel, 50 Hz, bending", steel, 50., 0., ExactDispersion::bending_wave,
            Complex(56.32803997556302, -57.24377542902166),
            {Complex(2.862213247514668, 2.816375778267227),
             Complex(44060.18418475403, -183735.3177761273),
             Complex(27012599.59697055, -26581361.23770373),
             Complex(5569162405656.547, 5431651027843.302)});
  reference("steel, 400 Hz, pressure", steel, 400., 200., ExactDispersion::pressure_wave,
            Complex(2.197766706828042, -0.1780583112027009),
            {Complex(0.00213604770066731, 0.02630604273005739),
             Complex(704459.700008106, -900719.5480367318),
             Complex(44.18336513740547, 178.4830502559897),
             Complex(4109377123.218216, 50340838535.58689)});
  reference("steel, 400 Hz, axial", steel, 400., 200., ExactDispersion::axial_wave,
            Complex(0.4935030663257098, -0.0401043267378345),
            {Complex(-0.07123052898243203, -0.3799099881865383),
             Complex(22060610.04850064, -34820575.90609348),
             Complex(-30.0418684258861, -82.07182743658151),
             Complex(42888367134.61025, 239770917442.265)});
  reference("steel, 400 Hz, bending", steel, 400., 200., ExactDispersion::bending_wave,
            Complex(56.28500973897305, -57.19815463862816),
            {Complex(2.861246192604195, 2.812374722002867),
             Complex(334216.2383150239, -4217074.515093769),
             Complex(26931686.13172292, -26532194.77441185),
             Complex(5567226482152.16, 5423880089254.54)});
  reference("power-law, 20 Hz, pressure", power_law_wall, 20., 0., ExactDispersion::pressure_wave,
            Complex(15.7900669135563, -0.9070260531284525),
            {Complex(0.005669040463342152, 0.09868486813920167),
             Complex(1590.855019763685, -1651.049651997443),
             Complex(2.761834476149391e-05, 0.0003969909907544263),
             Complex(-555749.737797755, 13496219.2179625)});
  reference("power-law, 20 Hz, axial", power_law_wall, 20., 0., ExactDispersion::axial_wave,
            Complex(2.573250843322603, -0.3004190601903429),
            {Complex(0.001856338514051416, 0.01606230553281564),
             Complex(-2559.726324200539, -134029.7238107588),
             Complex(-4.477490410288108e-06, 7.772570764292338e-07),
             Complex(93590379.34267762, 90214277.4140417)});
  reference("power-law, 20 Hz, bending", power_law_wall, 20., 0., ExactDispersion::bending_wave,
            Complex(335.4079623315413, -343.5786662108559),
            {Complex(2.147366730443079, 2.096299689887953),
             Complex(2299.817189765928, -7324.027563068082),
             Complex(8.923603466623581, -7.118265890825893),
             Complex(273352154.4869913, 319207223.0279558)});
  reference("power-law-nu, 20 Hz, pressure", power_law_nu, 20., 10., ExactDispersion::pressure_wave,
            Complex(15.592841797757593, -2.1310933296814896),
            {Complex(0.013319210768514437, 0.097452168959244513),
             Complex(1548.9440975590030, -2049.6512484491492),
             Complex(1.0036054710812446e-4, 3.1338270130035909e-4),
             Complex(563858.83333092993, 13678469.218911689)});
  reference("power-law-nu, 20 Hz, axial", power_law_nu, 20., 10., ExactDispersion::axial_wave,
            Complex(2.7820146509655887, -0.53114599623719273),
            {Complex(0.0032981478844738260, 0.017387849729039200),
             Complex(-130675.59493845158, -114726.44992168721),
             Complex(-3.6753723489278069e-6, 5.7032658506680781e-6),
             Complex(94622969.379997158, -1131298.2622638435)});
  reference("power-law-nu, 20 Hz, bending", power_law_nu, 20., 10., ExactDispersion::bending_wave,
            Complex(351.61639009921608, -360.89655978706335),
            {Complex(2.2556035504845266, 2.1976023566757953),
             Complex(1777.7432969166655, -8100.4334460984294),
             Complex(8.5440033270152060, -6.8638969748662418),
             Complex(289145653.28214915, 337442050.88041346)});
  reference("layered, 20 Hz, pressure", layered, 20., 10., ExactDispersion::pressure_wave,
            Complex(13.45782379884993, -2.402507701969906),
            {Complex(0.01081127467310527, 0.06055762890133674),
             Complex(1432.877065128578, -1933.648363797381),
             Complex(-0.000198391599968546, 0.0002600887615858212),
             Complex(58075.19335882576, 7131839.620861824)});
  reference("layered, 20 Hz, axial", layered, 20., 10., ExactDispersion::axial_wave,
            Complex(3.325186013844326, -0.6783994098962388),
            {Complex(0.003046195522677118, 0.01495027224809907),
             Complex(10873.58730726505, -55805.62161187123),
             Complex(0.416038894540702, 0.1082997874595059),
             Complex(18266148.30257037, 35897574.83277531)});
  reference("layered, 20 Hz, bending", layered, 20., 10., ExactDispersion::bending_wave,
            Complex(331.722221941734, -327.0376783715717),
            {Complex(1.471669593000732, 1.492749934668846),
             Complex(1907.439290972418, -4740.942441739046),
             Complex(9.698758800549657, -6.925942993326553),
             Complex(152392358.8591228, 208502680.9132485)});
  reference("rigid, 50 Hz, pressure", rigid, 50., 0., ExactDispersion::pressure_wave,
            Complex(0.2200194312567863, -0.009148341543590592));
  reference("rigid, 2000 Hz, pressure", rigid, 2000., 300., ExactDispersion::pressure_wave,
            Complex(8.51657257711117, -0.2568194566784521));
  reference("inviscid, 20 Hz, pressure", inviscid, 20., 0., ExactDispersion::pressure_wave,
            Complex(15.83955896834121, 0.));
  reference("inviscid, 20 Hz, axial", inviscid, 20., 0., ExactDispersion::axial_wave,
            Complex(2.511643508136675, 0.));
  reference("inviscid, 20 Hz, bending", inviscid, 20., 0., ExactDispersion::bending_wave,
            Complex(336.4595823521711, -344.792720259184));
}

void korteweg()
{
  // Long waves without viscosity: k = omega sqrt(rho (1/K + psi 2R/(Y h))), with Lame's psi exact
  // for any thickness where the wall has no inertia.
  const double radius = 0.01, young = 1e6, nu = 0.3, compressibility = 1e-5;
  const Material light = solid(1e-6, young, nu);
  for (const double ratio : {1e-4, 0.1, 0.6, 1., 2.5})
    for (const bool tethered : {false, true})
    {
      const double psi = ratio * (1. + nu) + 2. / (2. + ratio) * (tethered ? 1. - nu * nu : 1.);
      const double speed = 1. / std::sqrt(1000. * (compressibility + psi * 2. / (young * ratio)));
      // A frequency whose wave is 1e4 radii long.
      const double omega = 2. * pi * speed / (1e4 * radius);
      close("long wave, h/R " + std::to_string(ratio) + (tethered ? ", held" : ", free"),
            guessed(tube(radius, liquid(1000., 0., compressibility), {ratio * radius}, {light},
                         tethered),
                    omega),
            omega / speed, 2e-7);
    }
  // A thin wall: psi is 1 and 1 - nu^2.
  for (const bool tethered : {false, true})
  {
    const double psi = tethered ? 1. - nu * nu : 1.;
    const double speed = std::sqrt(young * 1e-5 / (2. * 1000. * psi));
    const double omega = 2. * pi * speed / (1e4 * radius);
    close(tethered ? "Moens and Korteweg, held" : "Moens and Korteweg, free",
          guessed(tube(radius, liquid(1000., 0.), {1e-5 * radius}, {light}, tethered), omega),
          omega / speed, 1e-5);
  }
}

/// Long waves in a tube held axially, whose outside is supported: Lame's displacement of a thick
/// ring with sigma_r = -k u_r outside, in closed form.
void support()
{
  const double radius = 0.01, young = 1e6, nu = 0.3, mu = young / (2. * (1. + nu));
  for (const double ratio : {1e-3, 0.1, 0.6, 2.5})
  {
    const double outer = (1. + ratio) * radius;
    TubeSection section =
        tube(radius, liquid(1000., 0., 1e-7), {ratio * radius}, {solid(1e-6, young, nu)}, true);
    section.radial_stiffness = 1.5 * ratio * young / radius;
    // u_r = A r + B/r, sigma_r = 2 mu (A/(1 - 2 nu) - B/r^2), -1 Pa inside.
    const double of_volume = 2. * mu / (1. - 2. * nu),
                 outside_a = of_volume + section.radial_stiffness * outer,
                 outside_b = -2. * mu / (outer * outer) + section.radial_stiffness / outer;
    const double b = 1. / (2. * mu / (radius * radius) + of_volume * outside_b / outside_a),
                 a = -outside_b / outside_a * b;
    const double widening = (a * radius + b / radius) / radius;
    const double speed = 1. / std::sqrt(1000. * (1e-7 + 2. * widening));
    const double omega = 2. * pi * speed / (1e4 * radius);
    close("long wave, supported, h/R " + std::to_string(ratio), guessed(section, omega),
          omega / speed, 1e-6);
  }
}

void tube_in_three_dimensions()
{
  // Phase speeds of an inviscid liquid in the tube of references on pulses in three dimensions,
  // from the script.
  const auto speed = [](const double frequency, const double wall_density, const bool tethered)
  {
    const TubeSection section =
        tube(5e-3, liquid(1000., 0.), {1e-3}, {solid(wall_density, 3e5, 0.3)}, tethered);
    // Followed from low frequencies.
    const unsigned int n_steps = 8;
    Complex k = guessed(section, 2. * pi * frequency / n_steps);
    for (unsigned int i = 2; i <= n_steps; ++i)
      k = root(section, 2. * pi * frequency * i / n_steps, k * (static_cast<double>(i) / (i - 1)));
    return 2. * pi * frequency / k.real();
  };
  check::relative("3-D tube, 20 Hz", speed(20., 1200., false), 5.03608565543, 1e-9);
  check::relative("3-D tube, 100 Hz", speed(100., 1200., false), 4.80371716127, 1e-9);
  check::relative("3-D tube, 167 Hz", speed(167., 1200., false), 4.36922474521, 1e-9);
  // What other theories said of it.
  check::relative("3-D tube, 20 Hz, published", speed(20., 1200., false), 5.035, 5e-4);
  check::relative("3-D tube, 100 Hz, published", speed(100., 1200., false), 4.803, 5e-4);
  check::relative("3-D tube, 167 Hz, published", speed(167., 1200., false), 4.371, 5e-4);
  check::relative("3-D tube, held", speed(0.1, 1200., true), 5.25281, 2e-6);
  check::relative("3-D tube, no inertia of the wall", speed(0.1, 1e-6, false), 5.06567, 2e-6);
  // With the wall's inertia a long wave has, by Lame's solution for pressure p and axial stress s,
  // 2 u_r/R = 2/Y (A p - nu s), A = (Ro^2 + R^2)/(Ro^2 - R^2) + nu, axial strain e = (s - nu B
  // p)/Y, B = 2 R^2/(Ro^2 - R^2), and rho_s omega^2 e = k^2 s, k^2 p = rho omega^2 2 u_r/R: with x
  // = Y k^2/(rho_s omega^2), x rho_s/(2 rho) = A - nu^2 B/(1 - x).
  const double ratio = 36. / 25., nu = 0.3, a = (ratio + 1.) / (ratio - 1.) + nu,
               b = 2. / (ratio - 1.);
  const double linear = -(0.6 + a),
               root_of = std::sqrt(linear * linear - 4. * 0.6 * (a - nu * nu * b));
  for (const bool pressure : {true, false})
  {
    const double x = (-linear + (pressure ? 1. : -1.) * root_of) / (2. * 0.6);
    const TubeSection section = tube(5e-3, liquid(1000., 0.), {1e-3}, {solid(1200., 3e5, nu)});
    const Complex k = guessed(
        section, 0.2 * pi, pressure ? ExactDispersion::pressure_wave : ExactDispersion::axial_wave);
    check::relative(pressure ? "3-D tube, long wave" : "3-D tube, long axial wave",
                    0.2 * pi / k.real(), std::sqrt(3e5 / 1200. / x), 1e-6);
  }
}

void rigid_tube()
{
  const double radius = 1e-3;
  const TubeSection inviscid = tube(radius, liquid(998., 0., 1. / 2.2e9), {}, {});
  close("rigid, sound", guessed(inviscid, 2. * pi * 1000.),
        2. * pi * 1000. * std::sqrt(998. / 2.2e9), 1e-12);
  for (const double frequency : {1., 30.})
  {
    const double omega = 2. * pi * frequency;
    const Complex argument = std::sqrt(-imaginary * omega * 998. / 1e-3) * radius;
    const Complex one_minus_f10 = -bessel_j_ratio(2, argument, 0, argument);
    close("rigid, Womersley at " + std::to_string(frequency) + " Hz",
          guessed(tube(radius, water, {}, {}), omega),
          omega * std::sqrt(998. / 2.2e9 / one_minus_f10), 1e-8);
  }
  // A very stiff elastic wall is rigid.
  close("stiff wall", guessed(tube(radius, water, {radius}, {solid(1000., 1e18, 0.3)}, true), 200.),
        guessed(tube(radius, water, {}, {}), 200.), 1e-7);
}

/// A gas in a pipe of steel, where the wall's axial wave is the faster one.
void gas_in_a_stiff_pipe()
{
  const Material air = liquid(1.2, 1.8e-5, 1. / 142e3);
  const TubeSection pipe = tube(5e-3, air, {1e-3}, {solid(7800., 200e9, 0.3)});
  for (const double frequency : {2., 2000.})
  {
    const std::string name = "gas at " + std::to_string(frequency) + " Hz, ";
    const double omega = 2. * pi * frequency;
    // The steel gives way by K 2 R/(Y h) = 7e-6 of the gas's own compression.
    close(name + "as in a rigid pipe", guessed(pipe, omega),
          guessed(tube(5e-3, air, {}, {}), omega), 5e-6);
    // Whoever follows a wave takes the root next to its guess.
    for (const auto family : {ExactDispersion::pressure_wave, ExactDispersion::axial_wave})
    {
      const Complex root_there = guessed(pipe, omega, family);
      check::is_true(name + "guess " + std::to_string(family),
                     std::abs(ExactDispersion(pipe).guess(family, omega) - root_there) <
                         0.1 * std::abs(root_there));
    }
    // The gas that the wall drags along has 4e-4 of its mass.
    close(name + "bar", guessed(pipe, omega, ExactDispersion::axial_wave).real(),
          omega * std::sqrt(7800. / 200e9), 1e-4);
  }
}

void group_speeds()
{
  const TubeSection inviscid = tube(1e-3, liquid(998., 0., 1. / 2.2e9), {}, {});
  const double k = 2. * pi * 1000. * std::sqrt(998. / 2.2e9);
  check::relative("group speed of sound", ExactDispersion(inviscid).group_speed(2. * pi * 1000., k),
                  std::sqrt(2.2e9 / 998.), 1e-6);
  // Near the ring frequency of a wall the group is much slower than the phase. Differences of
  // fourth order over one per cent of the frequency.
  const TubeSection thin = tube(12.5e-3, water, {0.1e-3}, {solid(880., 1.72e6, 0.49)});
  const ExactDispersion exact(thin);
  const double omega = 2. * pi * 150., step = 0.01 * omega;
  Complex centre = 0.;
  check::is_true(
      "root", exact.find_root(omega, exact.guess(ExactDispersion::pressure_wave, omega), centre));
  const auto k_at = [&](const double steps)
  {
    Complex result = 0.;
    exact.find_root(omega + steps * step, centre * (1. + 0.01 * steps), result);
    return result.real();
  };
  const double slope = (8. * (k_at(1.) - k_at(-1.)) - (k_at(2.) - k_at(-2.))) / (12. * step);
  const double group = exact.group_speed(omega, centre);
  check::relative("group speed in a thin tube", group, 1. / slope, 1e-5);
  check::is_true("slower than the phase", group < 0.9 * omega / centre.real());
}

void wall_alone()
{
  // Next to no liquid: waves of the shell. Membrane, about the middle radius: k^2 = m (m -
  // P/R^2)/(P (m
  // - Y/R^2)), P = Y/(1 - nu^2), m = rho omega^2: a bar's speed sqrt(Y/rho) for long waves, a
  // plate's sqrt(P/rho) above the ring frequency.
  const double radius = 0.1, thickness = 1e-4, middle = radius + 0.5 * thickness, young = 1e9,
               nu = 0.35, density = 1200.;
  const TubeSection shell =
      tube(radius, liquid(1e-9, 0.), {thickness}, {solid(density, young, nu)});
  const double plate = young / (1. - nu * nu), bar_speed = std::sqrt(young / density);
  for (const double ratio : {1e-3, 0.3, 10.})
  {
    const double omega = ratio * bar_speed / middle, m = density * omega * omega,
                 r2 = middle * middle;
    const double k = std::sqrt(m * (m - plate / r2) / (plate * (m - young / r2)));
    close("axial wave of the wall alone, omega R/c " + std::to_string(ratio),
          root(shell, omega, k * 1.01), k, 3e-6);
    if (ratio < 0.01)
      close("bar", k, omega / bar_speed, 1e-6);
    if (ratio > 5.)
      close("plate", k, omega * std::sqrt(density / plate), 2e-3);
  }
  const double fourth = std::pow(12. * (1. - nu * nu), 0.25) / std::sqrt(middle * thickness);
  // The next terms of the theory of shells are of the relative size h/R.
  close("bending wave of the wall alone", guessed(shell, 1e-3, ExactDispersion::bending_wave),
        fourth * std::exp(-0.25 * pi * imaginary), 1e-3);
  close("other bending wave", guessed(shell, 1e-3, ExactDispersion::other_bending_wave),
        fourth * std::exp(-0.75 * pi * imaginary), 1e-3);
}

void one_continuum()
{
  const Material wall = solid(1000., 0.8e6, 0.45);
  const Complex omega(100., -5.);
  const TubeSection plain = tube(0.01, blood, {1.5e-3}, {wall});
  const ExactDispersion dispersion(plain);
  for (const ExactDispersion::Family family : dispersion.families())
  {
    const Complex k = guessed(plain, omega, family);
    const std::string name = ", family " + std::to_string(family);
    close("two layers of one material" + name,
          root(tube(0.01, blood, {0.4e-3, 1.1e-3}, {wall, wall}), omega, k * 1.01), k, 1e-9);
    close("a layer of the liquid" + name,
          root(tube(0.007, blood, {3e-3, 1.5e-3}, {blood, wall}), omega, k * 1.01), k, 1e-9);
    // What is real in time.
    close("mirrored frequency" + name,
          guessed(plain, -std::conj(omega),
                  family == ExactDispersion::bending_wave ? ExactDispersion::other_bending_wave
                  : family == ExactDispersion::other_bending_wave ? ExactDispersion::bending_wave
                                                                  : family),
          -std::conj(k), 1e-9);
  }
  // A power law of exponent 0 is elastic.
  close("power law, n = 0", guessed(tube(0.01, blood, {1e-3}, {power_law(1000., 1e6, 0.)}), omega),
        guessed(tube(0.01, blood, {1e-3}, {solid(1000., 1e6, 0.5)}), omega), 1e-9);
  // A Maxwell branch that relaxes slowly is elastic, one that relaxes fast is viscous.
  Material slow = wall;
  slow.shear.branches[0].relaxation_time = 1e12;
  close("slow branch", guessed(tube(0.01, blood, {1e-3}, {slow}), omega),
        guessed(tube(0.01, blood, {1e-3}, {wall}), omega), 1e-9);
}

void balances()
{
  const Complex omega(2. * pi * 40., -15.);
  const TubeSection section = tube(0.01, oil, {2e-3}, {solid(1100., 2e6, 0.4)});
  const ExactDispersion dispersion(section);
  const double radius = 0.01, area = pi * radius * radius,
               wall_area = pi * (0.012 * 0.012 - radius * radius);
  for (const ExactDispersion::Family family : dispersion.families())
  {
    const std::string name = "family " + std::to_string(family);
    const Complex k = guessed(section, omega, family), minus_ik = -imaginary * k;
    const WaveMode mode = dispersion.mode(family, omega, k);
    const Complex flow = mode.junction[WaveMode::flow_rate];
    const Complex mean = flow / (imaginary * omega * area), inertia = -omega * omega;
    close(name + ", mass of the liquid", minus_ik * flow,
          -imaginary * omega *
              (2. * pi * radius * mode.wall_displacement + area * mode.section_pressure / 1.5e9),
          1e-9);
    close(name + ", momentum of the liquid", inertia * 870. * area * mean,
          -minus_ik * mode.junction[WaveMode::traction] * area +
              2. * pi * radius * mode.wall_shear_stress,
          1e-9);
    // The wall's own from Gauss points; the force of a bending wave is a small difference.
    close(name + ", axial momentum of the wall",
          inertia * 1100. * wall_area * mode.junction[WaveMode::axial_displacement] +
              2. * pi * radius * mode.wall_shear_stress,
          minus_ik * mode.junction[WaveMode::axial_force],
          family == ExactDispersion::pressure_wave || family == ExactDispersion::axial_wave ? 1e-5
                                                                                            : 0.02);
    const Complex unit = family == ExactDispersion::pressure_wave ? mean
                         : family == ExactDispersion::axial_wave
                             ? mode.junction[WaveMode::axial_displacement]
                             : mode.wall_displacement;
    close(name + ", unit amplitude", unit, 1.,
          family == ExactDispersion::axial_wave ? 0.02 : 1e-12); // there that of the inner surface
  }
}
void very_thin_wall()
{
  // h/R = 1e-3, where 190 bits of the conditions cancel: the moment of a bent shell is D k^2 u_r on
  // the circumference.
  const double radius = 0.01, thickness = 1e-5, young = 80e6, nu = 0.5;
  const TubeSection section =
      tube(radius, liquid(1000., 1e-9), {thickness}, {solid(1000., young, nu)}, true);
  const Complex omega(0., -5.76), k = guessed(section, omega, ExactDispersion::bending_wave);
  const WaveMode mode = ExactDispersion(section).mode(ExactDispersion::bending_wave, omega, k);
  const double stiffness = young * std::pow(thickness, 3) / (12. * (1. - nu * nu));
  close("very thin wall, moment", mode.junction[WaveMode::bending_moment],
        2. * pi * radius * stiffness * k * k * mode.junction[WaveMode::radial_displacement], 5e-3);
}
} // namespace

UNIT_TEST(exact_dispersion)
{
  references();
  korteweg();
  support();
  tube_in_three_dimensions();
  rigid_tube();
  gas_in_a_stiff_pipe();
  group_speeds();
  wall_alone();
  one_continuum();
  balances();
  very_thin_wall();
}
} // namespace test_of_exact_dispersion
