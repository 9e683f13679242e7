# SPDX-License-Identifier: MIT
strahl_test(checkpoint/test_checkpoint_file.cpp LABEL unit)
