// What no object of an instruction set may hold: a function that other files share.
namespace bodyline::model {

inline double stray_symbol(double x) { return 2.0 * x; }
double (*use_of_stray_symbol())(double) { return stray_symbol; }

}  // namespace bodyline::model
