# SPDX-License-Identifier: MIT
foreach(test aovs vec transform elements images sky mtl_materials shapes spheres instances faults materials unknowns
             substitutes auto_integrator older_scenes unused_numbers empty_media integrator_advice census_kinds census_files
             foreign_scenes other_names sensors animations named_indices spectra expansion volumes validate roots scenes
             shared_scenes)
  strahl_test(scene/test_${test}.cpp LABEL unit)
endforeach()
strahl_test(scene/test_fuzz.cpp LABEL fuzz)
