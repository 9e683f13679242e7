// SPDX-License-Identifier: MIT
// Types of plugins by the name of their element: Mitsuba 3.9 ("Plugin reference") and Mitsuba 0.6 (documentation,
// section 8), those that strahl has among them.
#include "scene/readers/foreign_plugins.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "did_you_mean.h"

namespace strahl {

const std::vector<std::string>& mitsuba_types(std::string_view tag) {
  static const std::map<std::string, std::vector<std::string>, std::less<>> types{
      {"shape", {"obj",        "ply",          "serialized",  "sphere",
                 "cylinder",   "disk",         "rectangle",   "cube",
                 "sdfgrid",    "bsplinecurve", "linearcurve", "merge",
                 "shapegroup", "instance",     "ellipsoids",  "ellipsoidsmesh",
                 "hair",       "heightfield",  "deformable",  "animatedinstance"}},
      {"bsdf",
       {"diffuse",
        "dielectric",
        "thindielectric",
        "roughdielectric",
        "conductor",
        "roughconductor",
        "hair",
        "measured",
        "measured_polarized",
        "plastic",
        "roughplastic",
        "pplastic",
        "bumpmap",
        "normalmap",
        "blendbsdf",
        "mask",
        "null",
        "twosided",
        "principled",
        "principledthin",
        "polarizer",
        "retarder",
        "circular",
        "opticalelement",
        "roughdiffuse",
        "coating",
        "roughcoating",
        "phong",
        "ward",
        "mixturebsdf",
        "hk",
        "irawan",
        "difftrans",
        "rtrans"}},
      {"emitter",
       {"area", "point", "constant", "envmap", "spot", "projector", "directional", "directionalarea", "sunsky",
        "timed_sunsky", "volumelight", "collimated", "sky", "sun"}},
      {"sensor",
       {"orthographic", "perspective", "thinlens", "radiancemeter", "irradiancemeter", "distant", "batch",
        "telecentric", "spherical", "fluencemeter", "perspective_rdist"}},
      {"texture",
       {"bitmap", "checkerboard", "mesh_attribute", "volume", "uniform", "regular", "irregular", "srgb", "d65",
        "blackbody", "rawconstant", "gridtexture", "scale", "vertexcolors", "wireframe", "curvature"}},
      {"medium", {"homogeneous", "heterogeneous"}},
      {"phase",
       {"isotropic", "hg", "rayleigh", "blendphase", "sggx", "tabphase", "microflake", "mixturephase", "kkay"}},
      {"volume", {"constvolume", "gridvolume", "hgridvolume"}},
      {"rfilter", {"box", "tent", "gaussian", "catmullrom", "mitchell", "lanczos"}},
      {"sampler",
       {"independent", "stratified", "multijitter", "orthogonal", "ldsampler", "halton", "hammersley", "sobol"}},
      {"film", {"hdrfilm", "specfilm", "ldrfilm", "tiledhdrfilm", "mfilm"}},
      {"integrator",
       {"direct",
        "path",
        "aov",
        "volpath",
        "volpathmis",
        "depth",
        "prb",
        "prb_basic",
        "direct_projective",
        "prb_projective",
        "prbvolpath",
        "moment",
        "stokes",
        "ptracer",
        "volpath_simple",
        "bdpt",
        "photonmapper",
        "ppm",
        "sppm",
        "pssmlt",
        "mlt",
        "erpt",
        "vpl",
        "irrcache",
        "adaptive",
        "multichannel",
        "field",
        "motion"}}};
  static const std::vector<std::string> none;
  const auto found = types.find(tag == "spectrum" ? "texture" : tag);
  return found == types.end() ? none : found->second;
}

std::string not_available(std::string_view tag, std::string_view type, const std::vector<std::string>& known) {
  const std::vector<std::string>& foreign = mitsuba_types(tag);
  if (std::find(foreign.begin(), foreign.end(), type) != foreign.end())
    return fmt::format("{} \"{}\" is not supported yet", tag, type);
  return fmt::format("unknown {} \"{}\"{}", tag, type, did_you_mean(type, known));
}

}  // namespace strahl
