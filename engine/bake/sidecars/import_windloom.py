"""Imports the wind images of this folder (16-bit ones as half floats) into Unreal with the right settings. In the editor, with the Python Editor Script
Plugin on: Tools > Execute Python Script, choose this file. The textures come to /Game/Windloom/@IDENTIFIER@."""
import pathlib

import unreal

FILES = [@FILE_LIST@]
TARGET = "/Game/Windloom/@IDENTIFIER@"


def import_task(path):
    task = unreal.AssetImportTask()
    task.filename = str(path)
    task.destination_path = TARGET
    task.automated = True
    task.replace_existing = True
    task.save = False
    return task


def set_up(texture, is_float):
    compression = unreal.TextureCompressionSettings
    texture.set_editor_property("srgb", False)
    texture.set_editor_property("compression_settings",
                                compression.TC_HDR if is_float else compression.TC_VECTOR_DISPLACEMENTMAP)
    texture.set_editor_property("mip_gen_settings", unreal.TextureMipGenSettings.TMGS_NO_MIPMAPS)
    texture.set_editor_property("address_x", unreal.TextureAddress.@ADDRESS_A@)
    texture.set_editor_property("address_y", unreal.TextureAddress.@ADDRESS_B@)


folder = pathlib.Path(__file__).resolve().parent
tasks = [import_task(folder / name) for name in FILES]
unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks(tasks)
for name, task in zip(FILES, tasks):
    for asset_path in task.imported_object_paths:
        asset = unreal.load_asset(asset_path)
        if isinstance(asset, unreal.Texture2D):
            set_up(asset, name.endswith(".exr") or "flow16." in name)
        unreal.EditorAssetLibrary.save_asset(asset_path)
