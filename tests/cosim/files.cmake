# What users write and read: scenario and robot files, traces, goldens, expectations, reports.
find_package(nlohmann_json REQUIRED)
add_unit_test(files_test
  SOURCES
    compare_test.cpp
    csv_reader_test.cpp
    expect_place_test.cpp
    expect_test.cpp
    fact_list_test.cpp
    golden_comparer_test.cpp
    golden_test.cpp
    injections_test.cpp
    junit_test.cpp
    path_error_test.cpp
    printable_test.cpp
    progress_bar_test.cpp
    refusal_text_test.cpp
    results_document_test.cpp
    robot_loader_test.cpp
    run_facts_moves_test.cpp
    run_facts_stops_test.cpp
    run_facts_test.cpp
    scenario_bad_input_test.cpp
    scenario_expect_test.cpp
    scenario_find_test.cpp
    scenario_loader_test.cpp
    scenario_moves_test.cpp
    scenario_override_test.cpp
    scenario_pins_test.cpp
    scenario_serial_test.cpp
    scenario_to_controller_test.cpp
    scenario_value_rule_test.cpp
    shell_text_test.cpp
    suggest_test.cpp
    summary_json_test.cpp
    summary_text_test.cpp
    text_file_test.cpp
    text_replace_test.cpp
    toml_limits_test.cpp
    trace_csv_test.cpp
  LIBRARIES armature_cosim nlohmann_json::nlohmann_json)

# What is written from the entries of keys is as committed, and the schemas are right.
add_test(NAME keys.fresh COMMAND keydoc --check ${PROJECT_SOURCE_DIR}/scenarios)
add_python_test(keys.schemas ${CMAKE_CURRENT_SOURCE_DIR}/test_key_schemas.py)
