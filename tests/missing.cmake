# cmake -DWHAT=... -P missing.cmake: a test that cannot run says so and fails, instead of being left out.
message(FATAL_ERROR "${WHAT} is missing, so the page of the workbench is not tested. Install it (tools/packages.sh), or configure "
                    "with -DMERKER_BROWSER_TESTS=OFF to leave these tests out.")
