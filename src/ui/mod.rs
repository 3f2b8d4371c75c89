//! The window: sketch in two views, watch and pull in the third.
//!
//! It reads the document and the newest snapshot; what a person does to them leaves as a
//! [`crate::edit::Command`] for the document, beside undo and redo, or as a [`crate::sim::SimCommand`] for the running
//! world, beside the models that it is built from and the wish that it stops building. What is kept in
//! files (scenes, tables, a person's patterns, changes to be recovered) is written by [`crate::io`].

pub(crate) mod action;
mod activation_fields;
mod active_springs_section;
mod ahead;
pub(crate) mod app;
mod autosave;
mod bodies;
mod body_tab;
mod breaks;
mod clipboard;
mod colliders_section;
mod comparison;
mod conductor;
mod context;
mod controls;
mod dialogs;
mod document;
mod drives;
mod editing;
mod effect;
mod elements_section;
mod ended;
mod export;
mod fault_report;
mod field;
mod follows_section;
pub(crate) mod gallery;
mod inelastic_fields;
mod input_order;
mod inspector;
mod loading;
mod material_fields;
mod material_presets;
pub(crate) mod menu;
mod motion_fields;
mod navigation;
mod next;
mod opening;
mod outline_row;
mod outliner;
mod panels_section;
mod patterns;
mod pins_section;
mod placed;
mod plots;
mod preferences;
mod recent_menu;
mod region_material_fields;
mod remedy;
mod report;
mod right_panel;
mod room_section;
mod runs;
mod said;
mod sampling;
mod sheets_section;
mod slow_motion;
mod status_bar;
mod stroke_choices;
pub(crate) mod theme;
mod thumbs;
mod time_section;
mod time_series;
mod timeline;
mod timescale;
mod top_bar;
mod transfer;
mod two_layer_fields;
mod unpin;
mod views;
mod voids_section;
mod wind_section;
mod world_tab;

pub(crate) use app::App;
pub use document::Document;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use thiserror::Error;

/// Under this name the system keeps what is remembered.
const NAME: &str = "sinew";

/// Why there is no window, or none any more.
#[derive(Debug, Error)]
pub enum NoWindow {
    /// None was opened.
    #[error(
        "no window could be opened ({0}); it needs a screen (DISPLAY or WAYLAND_DISPLAY) and a graphics driver, on \
         Debian: apt install libx11-6 libx11-xcb1 libxcursor1 libxi6 libxkbcommon-x11-0 libvulkan1 mesa-vulkan-drivers; \
         `sinew simulate` does the same work without one"
    )]
    NotOpened(String),
    /// It was open.
    #[error(
        "the window ended by a fault of this program ({0}); changes that were not saved are kept and offered at the next \
         start"
    )]
    Failed(String),
}

/// Opens the window on a document and returns when it is closed.
///
/// # Errors
/// [`NoWindow`] where there is no screen, no driver or a library is missing, or where an open one fails.
pub fn run(document: Document) -> Result<(), NoWindow> {
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("sinew")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([640.0, 400.0])
            .with_drag_and_drop(true),
        // The pictures bring their own; all else is of one colour.
        dithering: false,
        ..eframe::NativeOptions::default()
    };
    // A missing library makes a dependency panic; that is a sentence for the person, not a crash.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let opened = Arc::new(AtomicBool::new(false));
    let opening = Arc::clone(&opened);
    let outcome = catch_unwind(AssertUnwindSafe(move || {
        eframe::run_native(
            NAME,
            options,
            Box::new(move |creation| {
                std::panic::set_hook(hook);
                let given = !document.is_built_in();
                let mut app = App::new(&creation.egui_ctx, creation.wgpu_render_state.clone(), document);
                if let Some(folder) = eframe::storage_dir(NAME) {
                    app = app.with_pattern_folder(folder.join("patterns")).with_recovery(folder.join("recovery"));
                    app = app.with_ends_from_outside();
                }
                if let Some(storage) = creation.storage {
                    app.recall(&creation.egui_ctx, storage);
                }
                if !given {
                    app.welcome();
                }
                opening.store(true, Ordering::SeqCst);
                Ok(Box::new(app))
            }),
        )
    }));
    let problem = match outcome {
        Ok(Ok(())) => return Ok(()),
        Ok(Err(error)) => error.to_string(),
        Err(panic) => panic
            .downcast_ref::<String>()
            .cloned()
            .or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()))
            .unwrap_or_else(|| "the window system failed".to_owned()),
    };
    let problem = problem.lines().next().unwrap_or_default().trim_end_matches('.').to_owned();
    Err(if opened.load(Ordering::SeqCst) { NoWindow::Failed(problem) } else { NoWindow::NotOpened(problem) })
}
