# SPDX-License-Identifier: MIT
strahl_test(study/test_stress.cpp LABEL render)
strahl_test(study/test_contact_sheet.cpp LABEL unit)
