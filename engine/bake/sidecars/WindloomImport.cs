// Sets the import settings of the wind images in this folder: numbers, not colours. Keep it beside manifest.json.
#if UNITY_EDITOR
using System.IO;
using UnityEditor;
using UnityEngine;

public class WindloomImport_@IDENTIFIER@ : AssetPostprocessor
{
    void OnPreprocessTexture()
    {
        string folder = Path.GetDirectoryName(assetPath);
        if (!File.Exists(Path.Combine(folder, "manifest.json")) || !IsOurs(Path.GetFileName(assetPath))) return;
        var importer = (TextureImporter)assetImporter;
        importer.sRGBTexture = false;
        importer.mipmapEnabled = false;
        importer.npotScale = TextureImporterNPOTScale.None;
        importer.wrapMode = TextureWrapMode.@WRAP@;
        importer.filterMode = FilterMode.Bilinear;
        importer.textureCompression = TextureImporterCompression.Uncompressed;
        importer.maxTextureSize = 8192;
        if (!assetPath.EndsWith(".exr")) return;
        TextureImporterPlatformSettings settings = importer.GetDefaultPlatformTextureSettings();
        settings.format = TextureImporterFormat.RGBAHalf;
        settings.maxTextureSize = 8192;
        importer.SetPlatformTextureSettings(settings);
    }

    static bool IsOurs(string name)
    {
        return @FILE_TEST@;
    }
}
#endif
