//! Answers of picks.

mod camera;
mod path;
mod point;
mod region;

pub use camera::camera_to_json;
pub use point::PickReport;
pub use region::RegionReport;
