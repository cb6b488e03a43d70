# Unity builds compile several files as one, which takes less than half of the time
# (docs/measurements.md); tools/tidy compiles every file by itself. These files have a name of their
# own that another file has too, each in its unnamed namespace, and are compiled alone;
# direction_feed.cpp instantiates members of a template that another file instantiates for others.
function(neph_compile_alone folder)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/${folder}/)
  set_source_files_properties(${ARGN} DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

neph_compile_alone(core base/child_process.cpp camera/camera_moves.cpp optics/blue_noise.cpp
  optics/particle_size.cpp plugin/plugin_library.cpp session/settings.cpp
  transport/direction_feed.cpp)
neph_compile_alone(readers/raw_les sidecar.cpp)
neph_compile_alone(readers/grib codes.cpp)  # its fuzz target leaves this one out
file(GLOB action_tables RELATIVE ${PROJECT_SOURCE_DIR}/app CONFIGURE_DEPENDS app/ui/shell/actions_*.cpp)
neph_compile_alone(app ${action_tables} cli/bench/bench_growth.cpp cli/bench/bench_modes.cpp
  cli/bench/bench_reference.cpp cli/render/render_request.cpp
  render/engines/reference/trace_meter.cpp render/frame/frame_block.cpp ui/compare/compare.cpp
  ui/compare/compare_figures.cpp ui/panel/notice_box.cpp ui/presets/preset_card.cpp
  ui/presets/preset_thumbnails.cpp ui/shell/profile_overlay.cpp validate/scene_medium.cpp
  validate/scene_file.cpp validate/scene_trials.cpp ui/data/data_panel.cpp
  ui/fields/fields_phase.cpp ui/widgets/parameter_widget.cpp)
if(NEPHOSCOPE_TESTS)
  neph_compile_alone(tests cli/export_test.cpp cli/image_io_test.cpp cli/profile_test.cpp
    core/bindings_test.cpp core/camera/camera_path_test.cpp core/camera/camera_test.cpp gpu/yield_test.cpp
    gpu/reference/reference_test.cpp readers/raw_les_brick_test.cpp
    readers/raw_les_grads_test.cpp readers/raw_les_grid_test.cpp readers/raw_les_microhh_test.cpp
    readers/raw_les_names_test.cpp readers/raw_les_numbers_test.cpp readers/stretched_data_test.cpp)
endif()
